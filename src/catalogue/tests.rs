//! The catalogue is read, is consistent with itself, and computes.

use std::collections::BTreeSet;

use terramechanics::{
    Bekker, Error, ForceModel, JanosiHanamoto, Method, PressureSinkage, ShearLaw, Slip, Soil, SoilParams, Wheel, WheelParams,
};

use super::record::SOIL_FIELDS;
use super::*;

/// Relative difference that the last printed digit of a published product leaves.
const PRINTED_DIGITS: f64 = 1e-3;

#[test]
fn names_are_unique_and_the_letters_own_are_among_them() {
    for (ids, fewest) in [(wheel_ids(), 36), (soil_ids(), 65)] {
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
        assert!(ids.len() >= fewest);
        assert!(ids.iter().all(|id| id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')));
    }
    assert!(wheel("letter").is_some() && soil("letter-sand").is_some());
}

#[test]
fn every_value_has_a_source_a_grade_and_what_was_published() {
    let values =
        wheels().iter().flat_map(|wheel| wheel.values.values()).chain(soils().iter().flat_map(|soil| soil.values.values()));
    let mut count = 0;
    for value in values {
        assert!(value.value.is_finite() && !value.published.is_empty(), "{value:?}");
        count += 1;
    }
    assert!(count > 400);
    assert!(wheels().iter().all(|record| !record.source.is_empty()) && soils().iter().all(|record| !record.source.is_empty()));
}

#[test]
fn no_record_has_a_better_grade_than_its_best_value() {
    let of_wheels = wheels().iter().map(|record| (&record.id, record.grade, vec![&record.values]));
    let of_soils = soils().iter().map(|record| {
        let further = [record.shear.as_ref().map(|shear| &shear.values), record.contact.as_ref().map(|contact| &contact.values)];
        (&record.id, record.grade, further.into_iter().flatten().chain([&record.values]).collect())
    });
    for (id, grade, values) in of_wheels.chain(of_soils) {
        let grades = values.into_iter().flat_map(|values| values.values()).map(|value| value.grade.unwrap_or(grade));
        assert!(grades.min().is_none_or(|best| grade >= best), "{id}");
    }
}

#[test]
fn every_soil_names_only_parameters_of_its_law() {
    for record in soils() {
        let law = record.law.as_ref().map(|name| PressureSinkage::named(name).expect("a law"));
        for name in record.values.keys() {
            let of_law = law.is_some_and(|law| law.parameters.iter().any(|parameter| parameter.name == name));
            assert!(of_law || SOIL_FIELDS.contains(&name.as_str()), "{}: {name}", record.id);
        }
    }
}

/// The letter's own wheel has no lugs. Every other wheel has a known lug height or is marked.
#[test]
fn a_lug_height_is_published_or_marked_as_assumed() {
    for record in wheels() {
        let known = record.values.contains_key("lug_height_m");
        assert_eq!(record.assumes("lug_height_m"), !known && record.id != "letter", "{}", record.id);
    }
}

/// The number before a unit in a text.
fn number_before(text: &str, unit: &str) -> Option<f64> {
    text.split(unit).next().filter(|before| before.len() < text.len())?.split(' ').rfind(|word| !word.is_empty())?.parse().ok()
}

/// Masses and densities became loads and unit weights with the gravity that the catalogue itself gives.
#[test]
fn loads_and_unit_weights_are_those_of_a_published_mass_or_density() {
    let of = |id: &str| gravity().iter().find(|body| body.id == id).expect("a body").acceleration_m_s2;
    let (earth, moon, mars) = (of("earth"), of("moon"), of("mars"));
    let mut checked = 0;
    for record in wheels() {
        let Some(load) = record.values.get("nominal_load_n") else { continue };
        assert!(load.value > 0.0);
        let Some(mass) = number_before(&load.published, " kg x") else { continue };
        let acceleration = number_before(&load.published, " m/s2").expect("an acceleration");
        // Sources on Earth take 9.8 or 9.81 m/s².
        assert!([moon, mars].contains(&acceleration) || (acceleration - earth).abs() < 0.01, "{}", record.id);
        let wheels = number_before(&load.published, " wheels").unwrap_or(1.0);
        assert!((load.value - mass * acceleration / wheels).abs() < 0.06, "{}: {load:?}", record.id);
        checked += 1;
    }
    for record in soils() {
        let density = record.values.get("bulk_density_kg_m3");
        if let Some(of) = density {
            let per_litre = number_before(&of.published, " g/cm^3").map(|density| 1e3 * density);
            let published = number_before(&of.published, " kg/m3").or(per_litre).expect("a density");
            assert!((of.value / published - 1.0).abs() < PRINTED_DIGITS, "{}: {of:?}", record.id);
            checked += 1;
        }
        let Some(weight) = record.values.get("unit_weight_n_m3") else { continue };
        let Some(published) = number_before(&weight.published, " kg/m3") else { continue };
        assert_eq!(density.map(|density| density.value), Some(published), "{}", record.id);
        assert!((weight.value / (published * earth) - 1.0).abs() < PRINTED_DIGITS, "{}: {weight:?}", record.id);
        checked += 1;
    }
    assert!(checked >= 20, "only {checked} were derived");
}

#[test]
fn angles_are_those_of_the_published_degrees() {
    let mut checked = 0;
    for record in soils() {
        let Some(angle) = record.values.get("friction_angle_rad") else { continue };
        let Some(degrees) = number_before(&angle.published, " deg") else { continue };
        assert!((angle.value.to_degrees() - degrees).abs() < 1e-12, "{}: {angle:?}", record.id);
        checked += 1;
    }
    assert!(checked >= 40, "only {checked} were given in degrees");
}

/// A soil that lacks nothing carries every wheel that lacks nothing, unless its negative cohesive modulus takes away all
/// resistance under a wheel so narrow.
#[test]
fn every_entry_computes_or_says_what_it_lacks() {
    let complete: Vec<Wheel> = wheels()
        .iter()
        .filter(|record| record.missing().is_empty())
        .map(|record| {
            let value = |name: &str, default: f64| record.values.get(name).map_or(default, |value| value.value);
            Wheel::new(WheelParams {
                radius: value("radius_m", f64::NAN),
                width: value("width_m", f64::NAN),
                lug_height: value("lug_height_m", 0.0),
                lug_coefficient: value("lug_coefficient", Wheel::TYPICAL_LUG_COEFFICIENT),
            })
            .expect("a wheel")
        })
        .collect();
    assert_eq!(wheels().len() - complete.len(), 3);
    let (mut computed, mut too_narrow) = (0, 0);
    for record in soils().iter().filter(|record| record.missing().is_empty()) {
        let value = |name: &str| record.values[name].value;
        let law = record.pressure_sinkage().expect("a law");
        let soil = Soil::new(SoilParams {
            cohesion: value("cohesion_pa"),
            friction_angle: value("friction_angle_rad"),
            shear: record
                .shear()
                .or_else(|| Some(ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: value("shear_modulus_m") }))),
            pressure_sinkage: Some(law),
            unit_weight: record.number("unit_weight_n_m3"),
            lateral_shear_modulus: record.number("lateral_shear_modulus_m"),
            ..SoilParams::BARE
        })
        .expect("a soil");
        let contact = record.contact().unwrap_or(terramechanics::Contact::MIDPOINT);
        for &wheel in &complete {
            let system = terramechanics::WheelOnSoil { wheel, soil, contact };
            let gives_way =
                matches!(law, PressureSinkage::Bekker(Bekker { k_c, k_phi, .. }) if k_c / wheel.width() + k_phi <= 0.0);
            let rolling = system.rolling(Slip::new(0.2).expect("a slip"));
            if gives_way {
                assert!(matches!(rolling, Err(Error::ModulusNotPositive { .. })), "{} under {wheel:?}", record.id);
                too_narrow += 1;
                continue;
            }
            let rolling = rolling.expect("a rolling wheel");
            let patch = rolling.contact(0.05 * wheel.radius()).expect("a contact");
            assert!(ForceModel::at_rim(Method::Quadrature).forces(&patch).expect("forces").normal > 0.0);
            computed += 1;
        }
    }
    assert!(too_narrow > 0, "grc1-scm-calibrated gives way under the narrowest wheels");
    assert!(computed > 20 * complete.len(), "only {computed} pairs were computed");
}

/// What `modulus_unlike_soil` calls the spread of a kind: the largest pressure at 10 mm under a plate 0.1 m wide over the smallest, of
/// the soils whose law is Bekker's and no guess. Kinds that have clay beside sand, or grains beside ice, lie apart by more.
#[test]
fn the_pressures_of_a_kind_lie_apart_by_less_than_what_is_warned_of() {
    let of_kind = |kind: &str| {
        let founded = soils().iter().filter(|record| record.kind == kind && record.law.as_deref() == Some("bekker"));
        let pressure = |record: &SoilRecord| {
            let value = |name: &str| super::published::founded(&record.values, record.grade, name);
            Some((value("k_c")? / 0.1 + value("k_phi")?) * 0.01_f64.powf(value("n0")?))
        };
        let pressures: Vec<f64> = founded.filter_map(pressure).collect();
        assert!(pressures.len() >= 2, "{kind}");
        pressures.iter().copied().fold(0.0, f64::max) / pressures.iter().copied().fold(f64::INFINITY, f64::min)
    };
    assert_eq!(["lunar simulant", "test-bed sand"].map(|kind| format!("{:.1}", of_kind(kind))), ["5.8", "3.2"]);
    let kind = terramechanics::Caution::KINDS.iter().find(|kind| kind.code == "modulus_unlike_soil").expect("a kind");
    let range = kind.range.as_ref().expect("a range");
    let (lower, upper) = (range.lower.expect("an end"), range.upper.expect("an end"));
    assert!(upper > of_kind("lunar simulant") && (lower * upper - 1.0).abs() < 1e-15);
    assert!(range.source.contains("5.8"));
}
