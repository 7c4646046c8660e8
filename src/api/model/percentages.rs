//! The percentages in the statement of the model are computed.

use std::f64::consts::PI;

use terramechanics::{
    Contact, ContactParams, ForceModel, JanosiHanamoto, Method, Parametrised, PeakRule, ShearLaw, Slip, Soil, SoilParams, Wheel,
    WheelOnSoil, WheelParams,
};

use super::{Model, TEXT};
use crate::catalogue::{self, SoilRecord, WheelRecord};

fn wheel(record: &WheelRecord) -> Wheel {
    let values: Vec<_> = WheelParams::PARAMETERS.iter().map(|of| record.number(of.name).or(of.default())).collect();
    Wheel::new(WheelParams::from_values(&values).expect("all values")).expect("a wheel")
}

fn soil(record: &SoilRecord) -> Soil {
    let values = std::array::from_fn(|i| record.number(Soil::PARAMETERS[i].name));
    let modulus = || record.number(JanosiHanamoto::MODULUS.name);
    let shear = record.shear().or_else(|| Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: modulus()? })));
    let strength = SoilParams::from_values(values).expect("a strength");
    Soil::new(SoilParams { shear, pressure_sinkage: record.pressure_sinkage(), ..strength }).expect("a soil")
}

/// Relative differences of F_z between a closed form and the quadrature, over slips and depths that are shares of the radius;
/// points without an answer are left out.
fn gaps(systems: &[(Wheel, Soil)], rule: PeakRule, method: Method, depths: &[f64]) -> Vec<f64> {
    let contact = Contact::new(ContactParams { rule, ..ContactParams::MIDPOINT }).expect("a contact");
    let mut found = Vec::new();
    for (wheel, soil) in systems {
        let system = WheelOnSoil { wheel: *wheel, soil: *soil, contact };
        for slip in [0.0, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0] {
            let Ok(rolling) = system.rolling(Slip::new(slip).expect("a slip")) else { continue };
            for depth in depths {
                let Ok(patch) = rolling.contact(depth * wheel.radius()) else { continue };
                let force = |method| ForceModel::at_rim(method).forces(&patch).map(|forces| forces.normal);
                if let (Ok(exact), Ok(closed)) = (force(Method::Quadrature), force(method))
                    && exact > 0.0
                {
                    found.push(100.0 * (closed / exact - 1.0));
                }
            }
        }
    }
    found.sort_by(f64::total_cmp);
    found
}

/// The least, the median and the largest, without their signs.
fn sizes(gaps: &[f64]) -> [f64; 3] {
    let middle = 0.5 * (gaps[(gaps.len() - 1) / 2] + gaps[gaps.len() / 2]);
    [gaps[0], middle, gaps[gaps.len() - 1]].map(f64::abs)
}

fn statement() -> Model {
    serde_json::from_str(&TEXT).expect("the model is JSON")
}

/// The letter's wheel and sand, from a shallow contact to a deep one, and all that is complete in the catalogue.
#[test]
fn the_accuracy_of_the_closed_forms_is_as_stated() {
    let wheels: Vec<_> = catalogue::wheels().iter().filter(|record| record.missing().is_empty()).collect();
    let soils: Vec<_> = catalogue::soils().iter().filter(|record| record.missing().is_empty()).collect();
    let pairs: Vec<_> = wheels.iter().flat_map(|one| soils.iter().map(|other| (wheel(one), soil(other)))).collect();
    let letter = [(
        wheel(catalogue::wheel("letter").expect("the letter's wheel")),
        soil(catalogue::soil("letter-sand").expect("the letter's sand")),
    )];
    let both = |rule, method| {
        let letter = gaps(&letter, rule, method, &[0.0025, 0.01, 0.025, 0.05, 0.1, 0.2, 0.3]);
        let all = gaps(&pairs, rule, method, &[0.01, 0.05, 0.1, 0.2, 0.3]);
        assert!(letter.len() == 49 && all.len() > 10_000, "{} and {} points", letter.len(), all.len());
        assert!(letter[48] < 0.0 && all[0] < 0.0, "all of the letter's are less");
        (sizes(&letter), all[all.len() - 1] > 0.0, sizes(&all))
    };
    let stated = |name: &str| statement().methods.into_iter().find(|note| note.method == name).expect("the method").accuracy;
    let is_stated = |name: &str, said: String| assert!(stated(name).contains(&said), "{said}\n{}", stated(name));

    let ([most, _, least], exceeds, [below, median, above]) = both(PeakRule::Midpoint, Method::LINEARISED);
    assert!(exceeds);
    is_stated(
        "linearised",
        format!(
            "{least:.0} to {most:.0} % less on the letter's wheel and sand; over the catalogue from {below:.0} % less to {above:.0} % \
             more, median {median:.0} % less"
        ),
    );
    let ([most, _, least], exceeds, [below, median, above]) = both(PeakRule::Midpoint, Method::EXPLICIT);
    assert!(!exceeds);
    is_stated(
        "explicit",
        format!(
            "{least:.0} to {most:.0} % less on the letter's wheel and sand; over the catalogue {above:.0} to {below:.0} % less, median \
             {median:.0} %"
        ),
    );
    let ([most, _, least], exceeds, [below, median, above]) = both(PeakRule::HalfSinkage, Method::EXPLICIT);
    assert!(exceeds);
    is_stated(
        "explicit",
        format!(
            "{least:.0} to {most:.0} % less on the letter's, over the catalogue from {below:.0} % less to {above:.0} % more, median \
             {median:.0} % less"
        ),
    );
}

/// By hand: ∫(1 − u²)^n du from 0 to 1 is π/4 at n = 1/2 and 3π/16 at 3/2.
#[test]
fn the_error_of_bekkers_integral_is_as_stated() {
    let error = |exponent: f64, integral: f64| 100.0 * ((3.0 - exponent) / 3.0 / integral - 1.0);
    let said = format!("{:.0} % above at 1/2, {:.0} % below at 3/2", error(0.5, PI / 4.0), -error(1.5, 3.0 * PI / 16.0));
    let equations = statement().equations;
    let notes = || equations.iter().filter_map(|equation| equation.note.as_deref());
    assert_eq!(notes().filter(|note| note.contains('%')).count(), 1, "the percentages that are computed here");
    assert!(notes().any(|note| note.contains(&said)), "{said}");
}

/// The level of an interval is no figure of a result.
#[test]
fn the_share_of_the_strength_that_counts_is_as_stated() {
    let share = format!("less than {} %", 100.0 * terramechanics_identification::LEAST_MOBILISATION);
    let warnings = statement().warnings;
    let stated: Vec<_> = warnings
        .iter()
        .map(|note| note.meaning.replace("intervals of 95 %", ""))
        .filter(|meaning| meaning.contains('%'))
        .collect();
    assert!(matches!(&stated[..], [one] if one.contains(&share) && one.matches('%').count() == 1), "{stated:?}");
}

/// A percentage that no test computes is not stated.
#[test]
fn no_other_percentage_is_stated() {
    let text: serde_json::Value = serde_json::from_str(include_str!("../model.json")).expect("JSON");
    for (part, value) in text.as_object().expect("an object") {
        let count = value.to_string().matches('%').count();
        let computed = match part.as_str() {
            "methods" => 11,
            "equations" => 2,
            _ => 0,
        };
        assert_eq!(count, computed, "percentages in {part}");
    }
}
