//! How far the values of the catalogue reach. One that is far beyond is probably in another unit.

use std::sync::LazyLock;

use terramechanics::{JanosiHanamoto, Law, Parameter, PressureSinkage, ShearLaw, Soil, SoilParams, Wheel};

use super::{SoilRecord, is_of_exponent, size, soils, wheels};

/// What the extents are called as the source of a range.
pub(crate) const CATALOGUE: &str = "the catalogue of this service";

/// How many times beyond the extremes of the catalogue a value may lie. Another wheel or soil may well differ by so much, while
/// units (mm, cm, kPa) differ by ten times and more.
const MARGIN: f64 = 3.0;

/// The smallest and the largest value of one quantity in the catalogue.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Extent {
    pub(crate) quantity: String,
    /// By UCUM, save where an exponent is in it.
    pub(crate) unit: &'static str,
    /// The field of a request that has the value.
    pub(crate) pointer: String,
    /// The smallest; none where a small value is as good as zero.
    pub(crate) lower: Option<f64>,
    pub(crate) upper: f64,
    margin: f64,
}

/// A value far beyond what the catalogue has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Outside {
    pub(crate) extent: &'static Extent,
    pub(crate) value: f64,
}

impl Extent {
    /// The extent of values of the field at `pointer`. A 0 tells nothing of a unit and is left out; without any other value there
    /// is no extent.
    fn of([quantity, unit]: [&'static str; 2], pointer: &str, values: impl Iterator<Item = f64>) -> Option<Self> {
        let bounds = values.filter(|value| *value != 0.0).fold(None, |bounds: Option<(f64, f64)>, value| {
            Some(bounds.map_or((value, value), |(lower, upper)| (lower.min(value), upper.max(value))))
        });
        let (quantity, pointer) = (quantity.to_owned(), pointer.to_owned());
        bounds.map(|(lower, upper)| Self { quantity, unit, pointer, lower: Some(lower), upper, margin: MARGIN })
    }

    fn without_lower(self) -> Self {
        Self { lower: None, ..self }
    }

    /// Any value beyond the extremes themselves is outside.
    fn exact(self) -> Self {
        Self { margin: 1.0, ..self }
    }

    /// Whether any value beyond the extremes is outside.
    pub(crate) fn is_exact(&self) -> bool {
        self.margin == 1.0
    }

    fn called(self, quantity: String) -> Self {
        Self { quantity, ..self }
    }

    /// The value, if it lies outside; 0 never does.
    #[inline]
    fn left_by(extent: &'static Option<Self>, value: f64) -> Option<Outside> {
        let extent = extent.as_ref()?;
        let too_small = extent.lower.is_some_and(|lower| value * extent.margin < lower);
        let is_outside = value != 0.0 && (too_small || value > extent.upper * extent.margin);
        is_outside.then_some(Outside { extent, value })
    }
}

/// The extents of the quantities that wheels and soils have. A quantity that no record has, has none.
struct Extents {
    radius: Option<Extent>,
    width: Option<Extent>,
    lug_height: Option<Extent>,
    lug_ratio: Option<Extent>,
    cohesion: Option<Extent>,
    friction_angle: Option<Extent>,
    /// The soil's own.
    unit_weight: Option<Extent>,
    bulk_density: Option<Extent>,
    /// Displacement by which the shear law scales across.
    across: Option<Extent>,
    /// Of each shear law, its parameters in their order: lengths alone have an extent.
    shear: Vec<Vec<Option<Extent>>>,
    /// Of each pressure–sinkage law, its parameters in their order.
    pressure_sinkage: Vec<Vec<Option<Extent>>>,
}

const SHEAR_LENGTH: [&str; 2] = ["displacement by which the shear law scales", "m"];
const UNIT_WEIGHT: [&str; 2] = ["unit weight", "N/m3"];

static EXTENTS: LazyLock<Extents> = LazyLock::new(|| {
    let of_wheels = |name: &'static str| wheels().iter().filter_map(move |record| record.number(name));
    let ratios = wheels().iter().filter_map(|record| Some(record.number("lug_height_m")? / record.number("radius_m")?));
    let wheel = |about, name: &'static str| Extent::of(about, &format!("/wheel/{name}"), of_wheels(name));
    let soil = |about, of: &Parameter| Extent::of(about, &format!("/soil/{}", of.name), of_soils(of.name));
    Extents {
        radius: wheel(["wheel radius", "m"], "radius_m"),
        width: wheel(["wheel width", "m"], "width_m"),
        lug_height: wheel(["lug height", "m"], "lug_height_m").map(Extent::without_lower),
        lug_ratio: Extent::of(["lug height over radius", "1"], "/wheel/lug_height_m", ratios).map(Extent::without_lower),
        cohesion: soil(["cohesion", "Pa"], &Soil::COHESION),
        friction_angle: soil(["friction angle", "rad"], &Soil::FRICTION_ANGLE).map(Extent::exact),
        unit_weight: soil(UNIT_WEIGHT, &Soil::UNIT_WEIGHT),
        bulk_density: soil(["bulk density", "kg/m3"], &Soil::BULK_DENSITY),
        across: Extent::of(SHEAR_LENGTH, "/soil/lateral_shear_modulus_m", shear_lengths()),
        shear: ShearLaw::LAWS.iter().map(|law| law.parameters.iter().map(|of| of_shear_law(law, of)).collect()).collect(),
        pressure_sinkage: PressureSinkage::LAWS
            .iter()
            .map(|law| law.parameters.iter().map(|of| of_law(law, of)).collect())
            .collect(),
    }
});

fn of_soils(name: &'static str) -> impl Iterator<Item = f64> {
    soils().iter().filter_map(move |record| record.number(name))
}

/// The displacements by which shear laws scale, along the wheel and across.
fn shear_lengths() -> impl Iterator<Item = f64> {
    let peaks = soils().iter().filter_map(SoilRecord::shear).map(|law| law.scale());
    of_soils(JanosiHanamoto::MODULUS.name).chain(of_soils(Soil::LATERAL_SHEAR_MODULUS.name)).chain(peaks)
}

/// The extent of a parameter of a shear law: of its length, by which it scales.
fn of_shear_law(law: &Law<ShearLaw>, of: &Parameter) -> Option<Extent> {
    // The modulus of the law that none names stands in the soil itself.
    let place = if *of == JanosiHanamoto::MODULUS { "/soil" } else { "/soil/shear" };
    let is_length = of.unit == "m" && law.parameters.contains(of);
    is_length.then(|| Extent::of(SHEAR_LENGTH, &format!("{place}/{}", of.name), shear_lengths()))?
}

/// The extent of a parameter of a pressure–sinkage law. One without which the law can do tells nothing of a unit.
fn of_law(law: &'static Law<PressureSinkage>, of: &'static Parameter) -> Option<Extent> {
    let pointer = format!("/soil/pressure_sinkage/{}", of.name);
    if of.name == Soil::UNIT_WEIGHT.name {
        return Extent::of(UNIT_WEIGHT, &pointer, of_soils(of.name));
    }
    // What soils can have: with a minus as well, there is no smallest size.
    let bounds = law.fittable.iter().find(|fittable| fittable.parameter.name == of.name).map(|fittable| fittable.bounds);
    let is_signed = bounds.map_or(of.least, |[lower, _]| lower) < 0.0;
    if !of.is_required() || (is_signed && bounds.is_none()) {
        return None;
    }
    let extent = Extent::of([of.name, of.unit], &pointer, soils().iter().filter_map(|record| size(record, law, of)))?;
    let name = if is_signed { format!("|{}|", of.name) } else { of.name.to_owned() };
    let quantity = match PressureSinkage::LAWS.iter().flat_map(|law| law.parameters).find(|other| other.name == of.name) {
        _ if is_of_exponent(of.name) => format!("sinkage exponent {name}"),
        Some(first) if first.unit != of.unit => format!("{name} of the law `{}`", law.name),
        _ => name,
    };
    Some(if is_signed { extent.without_lower() } else { extent }.called(quantity))
}

/// What of a wheel and a soil is far beyond the catalogue.
pub(crate) fn outside(wheel: &Wheel, soil: &SoilParams) -> impl Iterator<Item = Outside> + use<> {
    let extents = &*EXTENTS;
    let (lug_height, radius) = (wheel.lug_height(), wheel.radius());
    let law = soil.pressure_sinkage.map(|law| within(PressureSinkage::LAWS, &extents.pressure_sinkage, law.law(), law.values()));
    let along = soil.shear.map(|law| within(ShearLaw::LAWS, &extents.shear, law.law(), law.values()));
    // Where one length is taken for the other it is told once.
    let across = soil.lateral_shear_modulus.filter(|across| soil.shear.is_none_or(|law| law.scale() != *across));
    let lugs = |extent: &'static Option<Extent>, value: f64| Extent::left_by(extent, value);
    let own = [
        Extent::left_by(&extents.radius, radius),
        Extent::left_by(&extents.width, wheel.width()),
        lugs(&extents.lug_height, lug_height).or_else(|| lugs(&extents.lug_ratio, lug_height / radius)),
        Extent::left_by(&extents.cohesion, soil.cohesion),
        Extent::left_by(&extents.friction_angle, soil.friction_angle),
    ];
    let across = Extent::left_by(&extents.across, across.unwrap_or(0.0));
    let weight = Extent::left_by(&extents.unit_weight, soil.unit_weight.unwrap_or(0.0));
    let density = Extent::left_by(&extents.bulk_density, soil.bulk_density.unwrap_or(0.0));
    let along = along.into_iter().flatten();
    own.into_iter().flatten().chain(along).chain(across).chain(law.into_iter().flatten()).chain(weight).chain(density)
}

/// Which values of a law are outside; one whose sign is open counts by its size.
fn within<F>(
    laws: &'static [Law<F>],
    extents: &'static [Vec<Option<Extent>>],
    law: &Law<F>,
    values: Vec<Option<f64>>,
) -> impl Iterator<Item = Outside> + use<F> {
    let of_law = laws.iter().zip(extents).find(|(known, _)| known.name == law.name).map_or(&[][..], |(_, extents)| extents);
    of_law.iter().zip(values).filter_map(|(extent, value)| {
        let is_signed = extent.as_ref().is_some_and(|extent| extent.lower.is_none());
        Extent::left_by(extent, if is_signed { value?.abs() } else { value? })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extent_of_values_is_theirs_without_zero() {
        let extent = Extent::of(["length", "m"], "", [0.0, 2.0, 0.5].into_iter()).expect("an extent");
        assert_eq!((extent.lower, extent.upper), (Some(0.5), 2.0));
        assert_eq!(Extent::of(["length", "m"], "", [0.0].into_iter()), None);
    }

    #[test]
    fn a_value_is_outside_beyond_three_times_the_extremes() {
        static LENGTH: LazyLock<Option<Extent>> = LazyLock::new(|| Extent::of(["length", "m"], "", [0.5, 2.0].into_iter()));
        let is_outside = |value: f64| Extent::left_by(&LENGTH, value).is_some();
        assert!(![0.0, 0.17, 0.5, 2.0, 5.99].into_iter().any(is_outside));
        assert!([1e-9, 0.166, 6.01, 1e9].into_iter().all(is_outside));
    }
}
