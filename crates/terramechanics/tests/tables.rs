//! What the laws declare of themselves holds together.

use std::collections::BTreeSet;

use terramechanics::{
    Braking, Contact, Error, ExitRule, ForceModel, Interface, Law, Method, Parameter, Parametrised, PeakRule, PressureSinkage,
    ShearLaw, SlipSinkage, Soil, SoilLaw, SoilParams, Thresholds, Wheel, WheelOnSoil, WheelParams,
};

/// A value that a reader takes and that differs for each place of a table.
fn value(place: usize, parameter: &Parameter) -> f64 {
    let share = 0.25 + 0.05 * place as f64;
    let (least, most) = (parameter.least.max(1e-3), parameter.most.min(2.0));
    least + share * (most - least)
}

/// That each law of a family is made of its table and gives its values back, and that its name is its own.
fn come_back<F: Copy + std::fmt::Debug>(laws: &'static [Law<F>], law_of: fn(&F) -> (&'static str, Vec<Option<f64>>)) {
    let names: BTreeSet<_> = laws.iter().map(|law| law.name).collect();
    assert_eq!(names.len(), laws.len());
    for law in laws {
        let values: Vec<_> = law.parameters.iter().enumerate().map(|(i, parameter)| Some(value(i, parameter))).collect();
        let made = law.from_values(&values).expect("all values are there");
        assert_eq!(law_of(&made), (law.name, values), "{made:?}");
        let required: Vec<_> = law.parameters.iter().filter(|parameter| parameter.is_required()).collect();
        match law.from_named(|_| None) {
            Ok(_) => assert!(required.is_empty(), "{}", law.name),
            Err(missing) => assert_eq!(missing.parameters, required, "{}", law.name),
        }
        assert!(!law.sources.is_empty() && law.doc.ends_with('.') && !law.formula.is_empty(), "{}", law.name);
        declared(law.parameters);
    }
}

/// That a table's bounds are what its requirement allows, and its names carry the unit.
fn declared(parameters: &[Parameter]) {
    let names: BTreeSet<_> = parameters.iter().map(|parameter| parameter.name).collect();
    assert_eq!(names.len(), parameters.len());
    for parameter in parameters {
        let Parameter { name, unit, meaning, least, most, .. } = *parameter;
        assert!(least < most && parameter.requirement.holds(least), "{name}");
        assert!(parameter.requirement.holds(if parameter.is_open_above() { most.next_down() } else { most }), "{name}");
        assert!(parameter.default().is_none_or(|default| (least..=most).contains(&default)), "{name}");
        assert!(meaning.ends_with('.'), "{name}");
        let suffix = match unit {
            "m" => "_m",
            "rad" => "_rad",
            "Pa" => "_pa",
            "N/m3" => "_n_m3",
            "kg/m3" => "_kg_m3",
            "m/s2" => "_m_s2",
            "s" => "_s",
            "N" => "_n",
            "N.m" => "_n_m",
            "m/s" => "_m_s",
            "rad/s" => "_rad_s",
            _ => "",
        };
        assert!(name.ends_with(suffix), "{name} in {unit}");
    }
}

#[test]
fn every_law_is_made_of_its_table_and_gives_its_values_back() {
    come_back(PressureSinkage::LAWS, |law| (law.law().name, law.values()));
    come_back(ShearLaw::LAWS, |law| (law.law().name, law.values()));
    come_back(SlipSinkage::LAWS, |law| (law.law().name, law.values()));
    come_back(PeakRule::LAWS, |law| (law.law().name, law.values()));
    come_back(ExitRule::LAWS, |law| (law.law().name, law.values()));
    come_back(Braking::LAWS, |law| (law.law().name, law.values()));
}

#[test]
fn what_has_no_law_is_declared_as_well() {
    for parameters in [
        WheelParams::PARAMETERS,
        Soil::PARAMETERS,
        Interface::PARAMETERS,
        Thresholds::PARAMETERS,
        WheelOnSoil::PARAMETERS,
        terramechanics::Velocities::PARAMETERS,
        &[terramechanics::Slip::RATIO, terramechanics::SlipAngle::ANGLE],
        &[terramechanics::Lambda::A, terramechanics::Lambda::B],
    ] {
        declared(parameters);
    }
    let wheel = [Some(0.2), Some(0.1), Some(0.01), Some(0.4)];
    assert_eq!(WheelParams::from_values(&wheel).expect("a wheel").values(), wheel);
    let soil = [Some(100.0), Some(0.5), None, Some(1.5e4), Some(1600.0), Some(3.7), Some(1e6)];
    assert_eq!(SoilParams::from_values(soil).expect("a soil").values(), soil);
}

/// A field that two laws share is one field on the wire: its bounds are the same.
#[test]
fn laws_that_share_a_name_share_its_bounds() {
    let tables = PressureSinkage::LAWS.iter().map(|law| law.parameters).chain(ShearLaw::LAWS.iter().map(|law| law.parameters));
    let all: Vec<&Parameter> = tables.flatten().collect();
    for one in &all {
        for other in all.iter().filter(|other| other.name == one.name) {
            assert_eq!((one.least, one.most, one.presence), (other.least, other.most, other.presence), "{}", one.name);
        }
    }
}

/// Without a law, what needs it says which; what does not need it gives the same answer.
#[test]
fn a_law_that_is_missing_is_named_by_what_needs_it() {
    let strength = SoilParams { cohesion: 500.0, friction_angle: 0.6, unit_weight: Some(1.5e4), ..SoilParams::BARE };
    let shear = ShearLaw::named("janosi_hanamoto").expect("a law").from_values(&[Some(0.02)]).expect("with a modulus");
    let values = [Some(0.0), Some(1e6), Some(1.0), Some(0.0), None];
    let pressure = PressureSinkage::named("bekker").expect("a law").from_values(&values).expect("with moduli");
    let wheel = WheelParams { radius: 0.2, width: 0.1, lug_height: 0.0, lug_coefficient: 0.5 };
    let system = |soil: SoilParams| WheelOnSoil {
        wheel: Wheel::new(wheel).expect("a wheel"),
        soil: Soil::new(soil).expect("a soil"),
        contact: Contact::MIDPOINT,
    };
    let slip = terramechanics::Slip::new(0.2).expect("a slip");
    let whole = system(SoilParams { shear: Some(shear), pressure_sinkage: Some(pressure), ..strength });
    let known = terramechanics::Coupled {
        normal_load: 50.0,
        torque: None,
        normal_stress_radius: terramechanics::NormalStressRadius::Rim,
    };
    let coupled = |system: &WheelOnSoil| {
        let rolling = system.rolling(slip)?;
        known.forces(&rolling.contact(0.02)?)
    };

    let sheared = system(SoilParams { shear: Some(shear), ..strength });
    assert_eq!(coupled(&sheared), coupled(&whole));
    let rolling = sheared.rolling(slip).expect("the shear law is there");
    let patch = rolling.contact(0.02).expect("a contact");
    let model = ForceModel::at_rim(Method::Quadrature);
    let missing = Error::MissingLaw(SoilLaw::PressureSinkage);
    assert_eq!(model.forces(&patch), Err(missing));
    assert_eq!(model.solve_sinkage(&rolling, 50.0), Err(missing));
    assert_eq!(terramechanics::Resistances::of(&sheared, 50.0, None), Err(missing));

    let pressed = system(SoilParams { pressure_sinkage: Some(pressure), ..strength });
    assert_eq!(pressed.rolling(slip), Err(Error::MissingLaw(SoilLaw::Shear)));
    let estimates = |system| terramechanics::Resistances::of(system, 50.0, None);
    assert_eq!(estimates(&pressed), estimates(&whole));
    let thrust = terramechanics::Resistances::of(&pressed, 50.0, Some(slip)).expect("estimates").thrust;
    assert_eq!(thrust, Err(terramechanics::Lacking::JanosiHanamoto));
}
