//! What stands in for values that were never published: the median of what other entries have, or a law of a named soil.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Serialize;
use terramechanics::{JanosiHanamoto, Parameter, PressureSinkage, Soil, Wheel};
use utoipa::ToSchema;

use super::published::{Alike, Published, Spread, of_kind_or_wider};
use super::record::{SoilRecord, WheelRecord};
use super::{soil, soils, wheels};

/// A value that a request takes with `"assume": true` where none was published.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
#[schema(as = CatalogueSubstitute)]
pub(crate) struct Substitute {
    /// The field, with a dot between an object and its field.
    #[schema(example = "shear_modulus_m")]
    pub(crate) field: String,
    /// The value, in SI units.
    pub(crate) value: f64,
    /// Its unit by UCUM, save where an exponent is in it.
    pub(crate) unit: &'static str,
    /// Where the value comes from.
    pub(crate) reason: String,
    /// The smallest published value that it was chosen from.
    pub(crate) low: f64,
    /// The largest one.
    pub(crate) high: f64,
    /// How many independent sources published these values: two fits of one laboratory, or two rows of one table, are one.
    #[schema(example = 5)]
    pub(crate) sources: usize,
}

impl Substitute {
    /// Whether it is for that parameter of a pressure–sinkage law.
    pub(crate) fn is_of_law(&self, parameter: &str) -> bool {
        self.field.split_once('.') == Some((LAW, parameter))
    }
}

/// The field of a soil that has the law.
const LAW: &str = "pressure_sinkage";

/// The kind of soils that are no grains.
const SNOW: &str = "snow";

/// Substitutes by the name of the entry.
type ByEntry = BTreeMap<&'static str, Vec<Substitute>>;

static OF_SOILS: LazyLock<ByEntry> =
    LazyLock::new(|| soils().iter().map(|record| (record.id.as_str(), of_soil(record))).collect());
static OF_WHEELS: LazyLock<ByEntry> =
    LazyLock::new(|| wheels().iter().map(|record| (record.id.as_str(), of_wheel(record))).collect());

impl SoilRecord {
    /// What stands in for its missing values.
    pub(crate) fn substitutes(&self) -> &'static [Substitute] {
        OF_SOILS.get(self.id.as_str()).map_or(&[], Vec::as_slice)
    }

    /// The soil whose pressure–sinkage law stands in for its own, if it has no whole one.
    pub(crate) fn lender(&self) -> Option<&'static SoilRecord> {
        soil(&self.law_substitute.as_ref()?.soil)
    }
}

impl WheelRecord {
    /// What stands in for its missing values.
    pub(crate) fn substitutes(&self) -> &'static [Substitute] {
        OF_WHEELS.get(self.id.as_str()).map_or(&[], Vec::as_slice)
    }
}

/// What stands in for the missing values of a soil.
fn of_soil(record: &SoilRecord) -> Vec<Substitute> {
    let own = [Soil::COHESION, Soil::FRICTION_ANGLE, JanosiHanamoto::MODULUS];
    let lacking = own.into_iter().filter(|parameter| record.number(parameter.name).is_none());
    let mut found: Vec<Substitute> = lacking.filter_map(|parameter| of_other_soils(record, &parameter)).collect();
    // The density of grains means nothing of snow, whose density is that of its ice and pores.
    if record.number(Soil::BULK_DENSITY.name).is_none() && record.kind != SNOW {
        found.extend(of_other_soils(record, &Soil::BULK_DENSITY));
    }
    found.extend(of_lender(record));
    found
}

/// The kinds of dry, loose grains: soils of planets, what simulates them, and sands of test beds. Soils of fields, with their clay and
/// their roots, say little of them.
const LOOSE: [&str; 5] = ["lunar", "lunar simulant", "martian", "martian simulant", "test-bed sand"];

/// The median of a value over the soils of the same kind, else over those alike, else over all.
fn of_other_soils(record: &SoilRecord, parameter: &Parameter) -> Option<Substitute> {
    let published = |is_alike: &dyn Fn(&str) -> bool| {
        let alike = soils().iter().filter(|other| is_alike(&other.kind));
        Spread::of(alike.filter_map(|other| Published::of(&other.values, other.grade, &other.source, parameter.name)))
    };
    let is_loose = |kind: &str| LOOSE.contains(&kind);
    let loose = Alike { which: "of planets, simulants and test beds", spread: published(&is_loose) };
    let all = Alike { which: "of the catalogue", spread: published(&|_| true) };
    let wider = is_loose(&record.kind).then_some(loose).into_iter().chain([all]);
    let of_kind = published(&|kind| kind == record.kind);
    let (reason, spread) = of_kind_or_wider(&record.kind, "value", ["soil", "soils"], of_kind, wider)?;
    let Spread { median: value, low, high, sources, .. } = spread;
    Some(Substitute { field: parameter.name.to_owned(), value, unit: parameter.unit, reason, low, high, sources })
}

/// The law of another soil, whole: moduli belong to their exponent.
fn of_lender(record: &SoilRecord) -> Vec<Substitute> {
    let (Some(lender), Some(chosen)) = (record.lender(), &record.law_substitute) else { return Vec::new() };
    let Some(law) = lender.law.as_deref().and_then(PressureSinkage::named) else { return Vec::new() };
    let of_law = |parameter: &'static Parameter| {
        let value = lender.number(parameter.name)?;
        let others = soils().iter().filter(|other| other.law == lender.law && other.kind == lender.kind);
        let published = |other: &'static SoilRecord| {
            Some(Published::by(other.number(parameter.name)?, &other.values, &other.source, parameter.name))
        };
        let spread = Spread::of(others.filter_map(published))?;
        Some(Substitute {
            field: format!("{LAW}.{}", parameter.name),
            value,
            unit: parameter.unit,
            reason: format!(
                "from the law `{}` of `{}`, taken as a whole because moduli belong to their exponent; {}",
                law.name, lender.id, chosen.reason
            ),
            low: spread.low,
            high: spread.high,
            sources: spread.sources,
        })
    };
    law.parameters.iter().filter_map(of_law).collect()
}

/// What stands in for the missing values of a wheel.
fn of_wheel(record: &WheelRecord) -> Vec<Substitute> {
    let mut found: Vec<Substitute> = width(record).into_iter().collect();
    if record.assumes(Wheel::LUG_HEIGHT.name) {
        let alike = wheels().iter().filter(|other| other.kind == record.kind);
        let published =
            |other: &'static WheelRecord| Published::of(&other.values, other.grade, &other.source, Wheel::LUG_HEIGHT.name);
        let spread = Spread::of(alike.filter_map(published));
        found.push(Substitute {
            field: Wheel::LUG_HEIGHT.name.to_owned(),
            value: 0.0,
            unit: Wheel::LUG_HEIGHT.unit,
            reason:
                "the wheel has or may have lugs of unknown height and is computed as smooth unless a request gives their height"
                    .to_owned(),
            low: 0.0,
            high: spread.as_ref().map_or(0.0, |spread| spread.high),
            sources: spread.map_or(0, |spread| spread.sources),
        });
    }
    found
}

/// The width by the shape of other wheels: their width over their radius.
fn width(record: &WheelRecord) -> Option<Substitute> {
    let (None, Some(radius)) = (record.number(Wheel::WIDTH.name), record.number(Wheel::RADIUS.name)) else { return None };
    let shape = |other: &'static WheelRecord| {
        let of = |name: &str| Published::of(&other.values, other.grade, &other.source, name);
        let width = of(Wheel::WIDTH.name)?;
        Some(Published { value: width.value / of(Wheel::RADIUS.name)?.value, ..width })
    };
    let of_kind = Spread::of(wheels().iter().filter(|other| other.kind == record.kind).filter_map(shape));
    let all = Alike { which: "of the catalogue", spread: Spread::of(wheels().iter().filter_map(shape)) };
    let (reason, spread) = of_kind_or_wider(&record.kind, "width over radius", ["wheel", "wheels"], of_kind, [all])?;
    Some(Substitute {
        field: Wheel::WIDTH.name.to_owned(),
        value: radius * spread.median,
        unit: Wheel::WIDTH.unit,
        reason: format!("its radius times the {reason}"),
        low: radius * spread.low,
        high: radius * spread.high,
        sources: spread.sources,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a request would have to add is what is proposed, and within the range that is told.
    #[test]
    fn every_missing_value_has_a_substitute() {
        let mut count = 0;
        for (id, missing, substitutes) in soils()
            .iter()
            .map(|record| (&record.id, record.missing(), record.substitutes()))
            .chain(wheels().iter().map(|record| (&record.id, record.missing(), record.substitutes())))
        {
            for name in missing {
                let of_name = |one: &&Substitute| one.field == name || one.field.split('.').next() == Some(name);
                let found: Vec<_> = substitutes.iter().filter(of_name).collect();
                assert!(!found.is_empty(), "{id} lacks {name}");
                for one in found {
                    assert!(one.low <= one.value && one.value <= one.high, "{id}: {one:?}");
                    count += 1;
                }
            }
        }
        assert!(count > 60, "{count}");
    }

    /// Of three moduli of snow two are guesses by a guideline, and so is the only one of a Martian soil. Those of Martian simulants are
    /// two fits of one laboratory. By hand, all 16 run from 0.515 to 38.1 mm, and those in the middle are 12 and 13 mm; the 8 of dry, loose
    /// soils run from 0.515 to 18.5 mm, and those in the middle are 11.4 and 13 mm.
    #[test]
    fn a_kind_with_few_sources_takes_the_range_of_those_alike_else_of_all() {
        let of = |id: &str| {
            let record = soil(id).expect("a soil");
            record.substitutes().iter().find(|one| one.field == "shear_modulus_m").expect("a substitute").clone()
        };
        let (all, loose) = (([0.000515, 0.0125, 0.0381], 13), ([0.000515, 0.0122, 0.0185], 6));
        for (id, why, (numbers, sources)) in [
            ("wong-snow-harrison", "the kind `snow` has 1 independent source, too few", all),
            ("exomars-es3-med", "the kind `martian simulant` has 1 independent source, too few", loose),
            ("mars-vl1-drift", "none of the kind `martian`", loose),
        ] {
            let found = of(id);
            assert!(found.reason.contains(why), "{found:?}");
            assert_eq!([found.low, found.value, found.high], numbers, "{id}");
            assert_eq!(found.sources, sources, "{id}");
        }
        let simulant = of("kls1");
        assert_eq!((simulant.low, simulant.high, simulant.sources), (0.0114, 0.0185, 3));
    }

    /// Lunar simulants of 1500, 1600, 1600, 1602, 1605, 1620, 1700 and 1740 kg/m³ have the median 1603.5 by hand. No Martian soil has a
    /// density, and snow is no soil of grains.
    #[test]
    fn a_density_comes_from_the_kind_else_from_all_grains() {
        let of = |id: &str| {
            let record = soil(id).expect("a soil");
            record.substitutes().iter().find(|one| one.field == "bulk_density_kg_m3").cloned()
        };
        let by_kind =
            |kind: &str| soils().iter().find(|record| record.kind == kind && record.number("bulk_density_kg_m3").is_none());
        let simulant = of(&by_kind("lunar simulant").expect("a simulant").id).expect("a density");
        assert!(simulant.reason.contains("of the kind `lunar simulant`") && simulant.value == 1603.5, "{simulant:?}");
        assert!(of("mars-vl1-drift").expect("a density").reason.contains("none of the kind `martian`"));
        assert_eq!((of("wong-snow-harrison"), of("hit-lss1")), (None, None));
    }

    #[test]
    fn a_lent_law_is_whole_and_comes_from_a_soil_that_has_its_own() {
        for record in soils() {
            assert_eq!(record.pressure_sinkage().is_none(), record.law_substitute.is_some(), "{}", record.id);
            let Some(lender) = record.lender() else { continue };
            assert!(lender.pressure_sinkage().is_some() && lender.law_substitute.is_none());
        }
    }
}
