//! The catalogue of wheels and soils: published values, each with its source, compiled in from `catalogue/*.json`.
//!
//! Adding an entry is adding a record to one of those files; the tests check that it can be read and computes, or says what
//! it lacks.

mod record;

pub(crate) use record::{SoilRecord, SoilView, WheelRecord, WheelView};

use std::sync::LazyLock;

static WHEELS: LazyLock<Vec<WheelRecord>> = LazyLock::new(|| compiled_in(include_str!("../../catalogue/wheels.json")));
static SOILS: LazyLock<Vec<SoilRecord>> = LazyLock::new(|| compiled_in(include_str!("../../catalogue/soils.json")));

fn compiled_in<T: serde::de::DeserializeOwned>(text: &str) -> Vec<T> {
    serde_json::from_str(text).expect("the catalogue is compiled in and its tests read it")
}

/// All wheels.
pub(crate) fn wheels() -> &'static [WheelRecord] {
    &WHEELS
}

/// All soils.
pub(crate) fn soils() -> &'static [SoilRecord] {
    &SOILS
}

/// The wheel of that name.
pub(crate) fn wheel(id: &str) -> Option<&'static WheelRecord> {
    wheels().iter().find(|record| record.id == id)
}

/// The soil of that name.
pub(crate) fn soil(id: &str) -> Option<&'static SoilRecord> {
    soils().iter().find(|record| record.id == id)
}

/// The names of all wheels.
pub(crate) fn wheel_ids() -> Vec<&'static str> {
    wheels().iter().map(|record| record.id.as_str()).collect()
}

/// The names of all soils.
pub(crate) fn soil_ids() -> Vec<&'static str> {
    soils().iter().map(|record| record.id.as_str()).collect()
}

#[cfg(test)]
mod tests {
    use super::record::SOIL_FIELDS;
    use super::*;
    use crate::request::LAWS;
    use std::collections::BTreeSet;
    use terramechanics::{ForceModel, JanosiHanamoto, Method, ShearLaw, Slip, Soil, SoilParams, Wheel, WheelParams};

    #[test]
    fn names_are_unique_and_the_letters_own_are_among_a_dozen() {
        for ids in [wheel_ids(), soil_ids()] {
            assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
            assert!(ids.len() >= 12);
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
        assert!(count > 100);
        assert!(
            wheels().iter().all(|record| !record.source.is_empty()) && soils().iter().all(|record| !record.source.is_empty())
        );
    }

    #[test]
    fn every_soil_names_only_parameters_of_its_law() {
        for record in soils() {
            let law = LAWS.iter().find(|law| law.name == record.law).expect("a law");
            for name in record.values.keys() {
                let own = SOIL_FIELDS.contains(&name.as_str());
                assert!(own || law.fields().any(|field| field == name), "{}: {name}", record.id);
            }
        }
    }

    /// A soil that lacks nothing carries every catalogue wheel that lacks nothing.
    #[test]
    fn every_entry_computes_or_says_what_it_lacks() {
        let wheels: Vec<Wheel> = wheels()
            .iter()
            .map(|record| {
                assert!(record.missing().is_empty(), "{}", record.id);
                let value = |name: &str, default: f64| record.values.get(name).map_or(default, |value| value.value);
                Wheel::new(WheelParams {
                    radius: value("radius_m", f64::NAN),
                    width: value("width_m", f64::NAN),
                    lug_height: value("lug_height_m", 0.0),
                    lug_coefficient: value("lug_coefficient", 0.5),
                })
                .expect("a wheel")
            })
            .collect();
        let mut computed = 0;
        for record in soils() {
            if !record.missing().is_empty() {
                continue;
            }
            let value = |name: &str| record.values[name].value;
            let soil = Soil::new(SoilParams {
                cohesion: value("cohesion_pa"),
                friction_angle: value("friction_angle_rad"),
                shear: record
                    .shear()
                    .unwrap_or_else(|| ShearLaw::JanosiHanamoto(JanosiHanamoto { modulus: value("shear_modulus_m") })),
                pressure_sinkage: record.pressure_sinkage().expect("a law"),
                unit_weight: record.number("unit_weight_n_m3"),
                lateral_shear_modulus: record.number("lateral_shear_modulus_m"),
            })
            .expect("a soil");
            let contact = record.contact().unwrap_or(terramechanics::Contact::MIDPOINT);
            for &wheel in &wheels {
                let system = terramechanics::WheelOnSoil { wheel, soil, contact };
                let rolling = system.rolling(Slip::new(0.2).expect("a slip")).expect("a rolling wheel");
                let patch = rolling.contact(0.05 * wheel.radius()).expect("a contact");
                assert!(ForceModel::at_rim(Method::Quadrature).forces(&patch).expect("forces").normal > 0.0);
                computed += 1;
            }
        }
        assert!(computed >= 12 * 10);
    }
}
