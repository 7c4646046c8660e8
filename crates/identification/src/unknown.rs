//! Which numbers can be fitted, within which bounds, and on which scale? Those that the tables of the model say.

mod range;
mod scale;
mod table;

use std::fmt;

use terramechanics::{
    Bekker, Direct, Fittable, Interface, JanosiHanamoto, Lambda, Law, Method, Parameter, SinkageExponent, Soil, SoilParams,
    Tolerance, WheelOnSoil, WongReece,
};

pub use range::Range;
pub(crate) use scale::Scale;

use crate::setup::{Setup, SinkageSource};
pub use table::Home;
use table::{COUNT, ROWS, Row};

/// A number that a fit may find: its place among those that the model's tables list.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Unknown(u8);

impl Unknown {
    /// All of them.
    pub const ALL: [Self; COUNT] = {
        let mut all = [Self(0); COUNT];
        let mut i = 0;
        while i < COUNT {
            all[i] = Self(i as u8);
            i += 1;
        }
        all
    };

    /// Cohesion c (Pa).
    pub const COHESION: Self = Self::of(&Soil::COHESION);
    /// Internal friction angle φ (rad).
    pub const FRICTION_ANGLE: Self = Self::of(&Soil::FRICTION_ANGLE);
    /// Granular stiffness ξ (N/m³), of the resistive force method.
    pub const GRANULAR_STIFFNESS: Self = Self::of(&Soil::GRANULAR_STIFFNESS);
    /// Shear deformation modulus K (m).
    pub const SHEAR_MODULUS: Self = Self::of(&JanosiHanamoto::MODULUS);
    /// Sinkage modulus K_s of the direct law (Pa/m^N).
    pub const SINKAGE_MODULUS: Self = Self::of(&Direct::K_S);
    /// Cohesive modulus k_c of Bekker's or Reece's law.
    pub const COHESIVE_MODULUS: Self = Self::of(&Bekker::K_C);
    /// Frictional modulus k_φ of Bekker's or Reece's law.
    pub const FRICTIONAL_MODULUS: Self = Self::of(&Bekker::K_PHI);
    /// Sinkage exponent without slip n0 (–).
    pub const BASE_EXPONENT: Self = Self::of(&SinkageExponent::BASE);
    /// Gain of the exponent with slip n1 (–).
    pub const SLIP_GAIN: Self = Self::of(&SinkageExponent::SLIP_GAIN);
    /// c1 of Wong & Reece's rule (–).
    pub const PEAK_INTERCEPT: Self = Self::of(&WongReece::C1);
    /// c2 of Wong & Reece's rule (–).
    pub const PEAK_SLIP_GAIN: Self = Self::of(&WongReece::C2);
    /// Friction angle δ between rim and soil (rad).
    pub const INTERFACE_FRICTION_ANGLE: Self = Self::of(&Interface::FITTABLE[0].parameter);
    /// Adhesion c_a between rim and soil (Pa).
    pub const INTERFACE_ADHESION: Self = Self::of(&Interface::FITTABLE[1].parameter);
    /// Displacement modulus between rim and soil (m).
    pub const INTERFACE_SHEAR_MODULUS: Self = Self::of(&Interface::FITTABLE[2].parameter);
    /// λ_A of the explicit method (–).
    pub const LAMBDA_A: Self = Self::of(&Lambda::A);
    /// λ_B of the explicit method (–).
    pub const LAMBDA_B: Self = Self::of(&Lambda::B);
    /// Static sinkage z0 (m).
    pub const STATIC_SINKAGE: Self = Self::of(&WheelOnSoil::STATIC_SINKAGE);

    /// What a fit with that setup finds under its name. A wheel without lugs slips on the grains before the soil shears in itself, so
    /// that without an interface of its own its strength and modulus are those between rim and soil. By resistive force the rim is as
    /// rough as the grains.
    #[must_use]
    pub fn found_by(self, setup: &Setup) -> Self {
        let by_grains = setup.model.method == Method::ResistiveForce;
        if setup.wheel.lug_height() > 0.0 || setup.contact.interface.is_some() || by_grains {
            return self;
        }
        [
            (Self::FRICTION_ANGLE, Self::INTERFACE_FRICTION_ANGLE),
            (Self::COHESION, Self::INTERFACE_ADHESION),
            (Self::SHEAR_MODULUS, Self::INTERFACE_SHEAR_MODULUS),
        ]
        .into_iter()
        .find_map(|(of_soil, of_interface)| (of_soil == self).then_some(of_interface))
        .unwrap_or(self)
    }

    /// The unknown that is that parameter. For one that cannot be fitted this does not compile.
    const fn of(parameter: &Parameter) -> Self {
        Self::ALL[table::place_of(parameter.name)]
    }

    const fn row(self) -> &'static Row {
        &ROWS[self.0 as usize]
    }

    const fn fittable(self) -> &'static Fittable {
        self.row().fittable
    }

    /// What is declared of it; where several laws have it, in the first of them.
    #[must_use]
    pub const fn parameter(self) -> &'static Parameter {
        &self.fittable().parameter
    }

    /// Its name for programs.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.parameter().name
    }

    /// What of a setup has it.
    #[must_use]
    pub const fn home(self) -> Home {
        self.row().home
    }

    /// Bounds where none are given: physical limits, wide enough for every measured soil.
    #[must_use]
    pub fn bounds(self) -> Range {
        let [lower, upper] = self.fittable().bounds;
        Range::new(lower, upper)
    }

    /// Range of further starts: the values of sands, regoliths and their simulants.
    pub(crate) fn search_range(self, bounds: &Range) -> Range {
        let [lower, upper] = self.fittable().usual;
        bounds.shared_with(&Range::new(lower, upper))
    }

    /// A start where neither the soil nor the caller has one.
    #[must_use]
    pub fn typical(self) -> f64 {
        self.fittable().typical
    }

    /// How far off a value may be and still be of use, beside a value of `value`; an estimate that is less certain counts as
    /// not determined.
    pub(crate) fn useful_width(self, value: f64, setup: &Setup) -> f64 {
        let other = |name: &str| Self::ALL.into_iter().find(|other| other.name() == name)?.value(setup);
        self.useful_beside(value, setup.wheel.width(), other)
    }

    /// The same under a plate or a wheel of that width, with the other parameters by name.
    pub(crate) fn useful_beside(self, value: f64, width: f64, other: impl Fn(&str) -> Option<f64>) -> f64 {
        match self.fittable().tolerance {
            Tolerance::Fixed(width) => width,
            Tolerance::Size => value.abs(),
            Tolerance::SizeOr(least) => value.abs().max(least),
            Tolerance::SizeOrShare { share, of } => value.abs().max(share * width * other(of).unwrap_or(0.0).abs()),
        }
    }

    /// The scale on which the fit moves the value.
    pub(crate) fn scale(self, bounds: &Range, start: f64) -> Scale {
        Scale::of(&self.fittable().step, bounds, start)
    }

    /// Its value in a setup; none where the setup has no such parameter.
    #[must_use]
    pub fn value(self, setup: &Setup) -> Option<f64> {
        let Setup { soil, contact, model, sinkage, .. } = setup;
        match self.row().home {
            Home::Soil if self == Self::GRANULAR_STIFFNESS && model.method != Method::ResistiveForce => None,
            Home::Soil => found(Soil::PARAMETERS, &soil.values(), self.name()),
            Home::Shear => soil.shear.and_then(|law| self.of_law(law.law(), &law.values())),
            Home::PressureSinkage => soil.pressure_sinkage.and_then(|law| self.of_law(law.law(), &law.values())),
            Home::Rule => self.of_law(contact.rule.law(), &contact.rule.values()),
            Home::Interface => contact.interface.and_then(|interface| interface.fitted(self.name())),
            Home::Method => match model.method {
                Method::Explicit { lambda_a: Lambda::Given(value), .. } if self == Self::LAMBDA_A => Some(value),
                Method::Explicit { lambda_b: Lambda::Given(value), .. } if self == Self::LAMBDA_B => Some(value),
                _ => None,
            },
            Home::Sinkage => match sinkage {
                SinkageSource::Static { static_sinkage, .. } => Some(*static_sinkage),
                SinkageSource::Measured | SinkageSource::Load | SinkageSource::UnderLoad => None,
            },
        }
    }

    /// The setup with another value; the same where it has no such parameter.
    #[must_use]
    pub fn replaced(self, setup: &Setup, value: f64) -> Setup {
        let mut changed = *setup;
        let Setup { soil, contact, model, sinkage, .. } = &mut changed;
        match self.row().home {
            Home::Soil => {
                let mut values = soil.values();
                if let Some(place) = Soil::PARAMETERS.iter().position(|parameter| parameter.name == self.name()) {
                    values[place] = Some(value);
                }
                let laws = (soil.shear, soil.pressure_sinkage);
                *soil = SoilParams::from_values(values).unwrap_or(*soil);
                (soil.shear, soil.pressure_sinkage) = laws;
            }
            Home::Shear => soil.shear = soil.shear.map(|law| self.in_law(law.law(), law.values(), value).unwrap_or(law)),
            Home::PressureSinkage => {
                soil.pressure_sinkage =
                    soil.pressure_sinkage.map(|law| self.in_law(law.law(), law.values(), value).unwrap_or(law));
            }
            Home::Rule => {
                let rule = contact.rule;
                contact.rule = self.in_law(rule.law(), rule.values(), value).unwrap_or(rule);
            }
            Home::Interface => contact.interface = contact.interface.map(|interface| interface.with_fitted(self.name(), value)),
            Home::Method => match &mut model.method {
                Method::Explicit { lambda_a: Lambda::Given(place), .. } if self == Self::LAMBDA_A => *place = value,
                Method::Explicit { lambda_b: Lambda::Given(place), .. } if self == Self::LAMBDA_B => *place = value,
                _ => {}
            },
            Home::Sinkage => {
                if let SinkageSource::Static { static_sinkage, .. } = sinkage {
                    *static_sinkage = value;
                }
            }
        }
        changed
    }

    /// Its value among those of a law, if the law has such an unknown.
    fn of_law<F>(self, law: &Law<F>, values: &[Option<f64>]) -> Option<f64> {
        let is_fittable = law.fittable.iter().any(|fittable| fittable.parameter.name == self.name());
        found(law.parameters, values, self.name()).filter(|_| is_fittable)
    }

    /// The law of these values with another one of its own; none where the law has no such unknown.
    fn in_law<F>(self, law: &Law<F>, mut values: Vec<Option<f64>>, value: f64) -> Option<F> {
        self.of_law(law, &values)?;
        let place = law.parameters.iter().position(|parameter| parameter.name == self.name())?;
        values[place] = Some(value);
        law.from_values(&values).ok()
    }
}

/// The value of a name.
fn found(parameters: &[Parameter], values: &[Option<f64>], name: &str) -> Option<f64> {
    parameters.iter().zip(values).find(|(parameter, _)| parameter.name == name).and_then(|(_, value)| *value)
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.parameter().symbol)
    }
}

impl fmt::Debug for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Unknown({})", self.name())
    }
}
