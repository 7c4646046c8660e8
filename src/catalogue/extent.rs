//! How far the values of the catalogue reach. One that is far beyond is probably in another unit.

use std::sync::LazyLock;

use terramechanics::{Bekker, Diameter, Direct, PressureSinkage, Reece, ShearLaw, SoilParams, Wheel};

use super::{SoilRecord, soils, wheels};

/// What the extents are called as the source of a range.
pub(crate) const CATALOGUE: &str = "the catalogue of this service";

/// How many times beyond the extremes of the catalogue a value may lie. Another wheel or soil may well differ by so much, while
/// units (mm, cm, kPa) differ by ten times and more.
const MARGIN: f64 = 3.0;

/// The smallest and the largest value of one quantity in the catalogue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extent {
    pub(crate) quantity: &'static str,
    /// By UCUM, save where an exponent is in it.
    pub(crate) unit: &'static str,
    /// The smallest; none where a small value is as good as zero.
    pub(crate) lower: Option<f64>,
    pub(crate) upper: f64,
    margin: f64,
}

/// A value far beyond what the catalogue has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Outside {
    pub(crate) extent: &'static Extent,
    /// The field of a request that has the value.
    pub(crate) pointer: &'static str,
    pub(crate) value: f64,
}

impl Extent {
    /// The extent of values. A 0 tells nothing of a unit and is left out; without any other value there is no extent.
    fn of([quantity, unit]: [&'static str; 2], values: impl Iterator<Item = f64>) -> Option<Self> {
        let bounds = values.filter(|value| *value != 0.0).fold(None, |bounds: Option<(f64, f64)>, value| {
            Some(bounds.map_or((value, value), |(lower, upper)| (lower.min(value), upper.max(value))))
        });
        bounds.map(|(lower, upper)| Self { quantity, unit, lower: Some(lower), upper, margin: MARGIN })
    }

    fn without_lower(self) -> Self {
        Self { lower: None, ..self }
    }

    /// Any value beyond the extremes themselves is outside.
    fn exact(self) -> Self {
        Self { margin: 1.0, ..self }
    }

    /// The value, if it lies outside; 0 never does.
    #[inline]
    fn left_by(extent: &'static Option<Self>, pointer: &'static str, value: f64) -> Option<Outside> {
        let extent = extent.as_ref()?;
        let too_small = extent.lower.is_some_and(|lower| value * extent.margin < lower);
        let is_outside = value != 0.0 && (too_small || value > extent.upper * extent.margin);
        is_outside.then_some(Outside { extent, pointer, value })
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
    /// Displacements by which shear laws scale, along the wheel and across.
    shear_lengths: [Option<Extent>; 2],
    /// The soil's own, and that of Reece's law.
    unit_weights: [Option<Extent>; 2],
    /// For each law: its two moduli, or none and its only one, and the exponent n0.
    bekker: [Option<Extent>; 3],
    direct: [Option<Extent>; 3],
    reece: [Option<Extent>; 3],
    diameter: [Option<Extent>; 3],
}

const EXPONENT: [&str; 2] = ["sinkage exponent n0", "1"];

static EXTENTS: LazyLock<Extents> = LazyLock::new(|| {
    let of_wheels = |name: &'static str| wheels().iter().filter_map(move |record| record.number(name));
    let of_soils = |name: &'static str| soils().iter().filter_map(move |record| record.number(name));
    let of_law = |law: &'static str, name: &'static str| {
        soils().iter().filter(move |record| record.law.as_deref() == Some(law)).filter_map(move |record| record.number(name))
    };
    let ratios = wheels().iter().filter_map(|record| Some(record.number("lug_height_m")? / record.number("radius_m")?));
    let peaks = soils().iter().filter_map(SoilRecord::shear).map(|law| length(&law));
    let lengths = of_soils("shear_modulus_m").chain(of_soils("lateral_shear_modulus_m")).chain(peaks);
    let exponent = |law: &'static str| Extent::of(EXPONENT, of_law(law, "n0"));
    let shear_length = Extent::of(["displacement by which the shear law scales", "m"], lengths);
    let unit_weight = Extent::of(["unit weight", "N/m3"], of_soils("unit_weight_n_m3"));
    let two_of_a_law = |law: &'static str, [k_c, k_phi]: [[&'static str; 2]; 2]| {
        let cohesive = Extent::of(k_c, of_law(law, "k_c").map(f64::abs)).map(Extent::without_lower);
        [cohesive, Extent::of(k_phi, of_law(law, "k_phi")), exponent(law)]
    };
    Extents {
        radius: Extent::of(["wheel radius", "m"], of_wheels("radius_m")),
        width: Extent::of(["wheel width", "m"], of_wheels("width_m")),
        lug_height: Extent::of(["lug height", "m"], of_wheels("lug_height_m")).map(Extent::without_lower),
        lug_ratio: Extent::of(["lug height over radius", "1"], ratios).map(Extent::without_lower),
        cohesion: Extent::of(["cohesion", "Pa"], of_soils("cohesion_pa")),
        friction_angle: Extent::of(["friction angle", "rad"], of_soils("friction_angle_rad")).map(Extent::exact),
        shear_lengths: [shear_length; 2],
        unit_weights: [unit_weight; 2],
        bekker: two_of_a_law("bekker", [["|k_c|", "N/m^(n+1)"], ["k_phi", "N/m^(n+2)"]]),
        // Few soils have it; Bekker's K_s = k_c/b + k_phi, of which k_phi is the larger part, is the same in the same unit.
        direct: [
            None,
            Extent::of(["k_s", "Pa/m^n"], of_law("direct", "k_s").chain(of_law("bekker", "k_phi"))),
            Extent::of(EXPONENT, of_law("direct", "n0").chain(of_law("bekker", "n0"))),
        ],
        reece: two_of_a_law("reece", [["|k_c| of Reece's law", "1"], ["k_phi of Reece's law", "1"]]),
        diameter: [None, Extent::of(["k of the law `diameter`", "N/m^(n+m+2)"], of_law("diameter", "k")), exponent("diameter")],
    }
});

/// What of a wheel and a soil is far beyond the catalogue.
pub(crate) fn outside(wheel: &Wheel, soil: &SoilParams) -> impl Iterator<Item = Outside> + use<> {
    let extents = &*EXTENTS;
    let (lug_height, radius) = (wheel.lug_height(), wheel.radius());
    let exponent = soil.pressure_sinkage.map_or(0.0, |law| law.exponent().base);
    let (of_law, weight_of_law) = match soil.pressure_sinkage {
        None => ([None; 3], None),
        Some(PressureSinkage::Bekker(Bekker { k_c, k_phi, .. })) => {
            (each(&extents.bekker, MODULI, [k_c.abs(), k_phi, exponent]), None)
        }
        Some(PressureSinkage::Direct(Direct { k_s, .. })) => (each(&extents.direct, MODULUS, [0.0, k_s, exponent]), None),
        Some(PressureSinkage::Reece(Reece { k_c, k_phi, unit_weight, .. })) => {
            (each(&extents.reece, MODULI, [k_c.abs(), k_phi, exponent]), Some(unit_weight))
        }
        Some(PressureSinkage::Diameter(Diameter { k, .. })) => (each(&extents.diameter, COEFFICIENT, [0.0, k, exponent]), None),
    };
    let weights = each(&extents.unit_weights, WEIGHTS, [soil.unit_weight.unwrap_or(0.0), weight_of_law.unwrap_or(0.0)]);
    // Where one length is taken for the other it is told once.
    let along = soil.shear.as_ref().map_or(0.0, length);
    let across = soil.lateral_shear_modulus.filter(|across| *across != along).unwrap_or(0.0);
    let lengths = match soil.shear {
        None | Some(ShearLaw::JanosiHanamoto(_)) => ["/soil/shear_modulus_m", ACROSS],
        Some(ShearLaw::WongResidual(_) | ShearLaw::WongPeak(_)) => ["/soil/shear/peak_displacement_m", ACROSS],
    };
    let lugs = |extent: &'static Option<Extent>, value: f64| Extent::left_by(extent, "/wheel/lug_height_m", value);
    let own = [
        Extent::left_by(&extents.radius, "/wheel/radius_m", radius),
        Extent::left_by(&extents.width, "/wheel/width_m", wheel.width()),
        lugs(&extents.lug_height, lug_height).or_else(|| lugs(&extents.lug_ratio, lug_height / radius)),
        Extent::left_by(&extents.cohesion, "/soil/cohesion_pa", soil.cohesion),
        Extent::left_by(&extents.friction_angle, "/soil/friction_angle_rad", soil.friction_angle),
    ];
    own.into_iter().chain(each(&extents.shear_lengths, lengths, [along, across])).chain(of_law).chain(weights).flatten()
}

const N0: &str = "/soil/pressure_sinkage/n0";
const ACROSS: &str = "/soil/lateral_shear_modulus_m";
const WEIGHTS: [&str; 2] = ["/soil/unit_weight_n_m3", "/soil/pressure_sinkage/unit_weight_n_m3"];

// For each law: the pointers of its two moduli, or none and its only one, and of the exponent.
const MODULI: [&str; 3] = ["/soil/pressure_sinkage/k_c", "/soil/pressure_sinkage/k_phi", N0];
const MODULUS: [&str; 3] = ["", "/soil/pressure_sinkage/k_s", N0];
const COEFFICIENT: [&str; 3] = ["", "/soil/pressure_sinkage/k", N0];

fn each<const N: usize>(
    extents: &'static [Option<Extent>; N],
    pointers: [&'static str; N],
    values: [f64; N],
) -> [Option<Outside>; N] {
    std::array::from_fn(|i| Extent::left_by(&extents[i], pointers[i], values[i]))
}

/// The displacement (m) by which a shear law scales.
fn length(law: &ShearLaw) -> f64 {
    match law {
        ShearLaw::JanosiHanamoto(law) => law.modulus,
        ShearLaw::WongResidual(law) => law.peak_displacement,
        ShearLaw::WongPeak(law) => law.peak_displacement,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extent_of_values_is_theirs_without_zero() {
        let extent = Extent::of(["length", "m"], [0.0, 2.0, 0.5].into_iter()).expect("an extent");
        assert_eq!((extent.lower, extent.upper), (Some(0.5), 2.0));
        assert_eq!(Extent::of(["length", "m"], [0.0].into_iter()), None);
    }

    #[test]
    fn a_value_is_outside_beyond_three_times_the_extremes() {
        static LENGTH: Option<Extent> = Some(Extent { quantity: "length", unit: "m", lower: Some(0.5), upper: 2.0, margin: 3.0 });
        let is_outside = |value: f64| Extent::left_by(&LENGTH, "", value).is_some();
        assert!(![0.0, 0.17, 0.5, 2.0, 5.99].into_iter().any(is_outside));
        assert!([1e-9, 0.166, 6.01, 1e9].into_iter().all(is_outside));
    }
}
