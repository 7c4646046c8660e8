//! How far the published values of a kind of soil lie apart, for those who know the kind and not the soil.
//!
//! Each value of the strength spreads by itself, over what the soils of the kind have. The parameters of a pressure–sinkage law do
//! not: moduli belong to their exponent, so that the law of one soil is taken as a whole.

use terramechanics::{JanosiHanamoto, Parameter, PressureSinkage, Soil};

use super::published::founded;
use super::record::SoilRecord;
use super::soils;

/// The published spread of the kind of a soil.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spread {
    pub(crate) values: Vec<SpreadValue>,
    pub(crate) law: Option<SpreadLaw>,
    /// What does not spread.
    pub(crate) held: Vec<Held>,
}

/// The published values of a field.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SpreadValue {
    /// The field of a soil.
    pub(crate) field: &'static str,
    /// Ascending.
    pub(crate) values: Vec<f64>,
    /// The soils that have them, in the same order.
    pub(crate) soils: Vec<&'static str>,
    pub(crate) reason: String,
}

/// The published laws of one form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SpreadLaw {
    pub(crate) parameters: Vec<&'static str>,
    /// A column for each parameter, a row for each soil.
    pub(crate) columns: Vec<Vec<f64>>,
    pub(crate) soils: Vec<&'static str>,
    pub(crate) reason: String,
}

/// A field that keeps its value, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Held {
    pub(crate) field: &'static str,
    pub(crate) reason: String,
}

/// The field of a soil that has the law.
pub(crate) const LAW: &str = "pressure_sinkage";

impl SoilRecord {
    /// The spread of what the soils of its kind have.
    pub(crate) fn spread(&'static self) -> Spread {
        let own = [&Soil::COHESION, &Soil::FRICTION_ANGLE, &JanosiHanamoto::MODULUS];
        let mut spread = Spread { values: Vec::new(), law: None, held: Vec::new() };
        for parameter in own {
            let has_no_influence = *parameter == JanosiHanamoto::MODULUS && self.shear().is_some();
            if has_no_influence {
                continue;
            }
            match self.spread_of(parameter) {
                Ok(value) => spread.values.push(value),
                Err(reason) => spread.held.push(Held { field: parameter.name, reason }),
            }
        }
        match self.spread_of_law() {
            Ok(law) => spread.law = Some(law),
            Err(reason) => spread.held.push(Held { field: LAW, reason }),
        }
        spread
    }

    /// The soils of its kind.
    fn of_kind(&self) -> impl Iterator<Item = &'static Self> {
        soils().iter().filter(move |other| other.kind == self.kind)
    }

    fn spread_of(&self, parameter: &'static Parameter) -> Result<SpreadValue, String> {
        let value = |other: &'static Self| Some((founded(&other.values, other.grade, parameter.name)?, other.id.as_str()));
        let mut found: Vec<(f64, &'static str)> = self.of_kind().filter_map(value).collect();
        found.sort_by(|one, other| one.0.total_cmp(&other.0));
        let differ = found.windows(2).any(|pair| pair[0].0 < pair[1].0);
        if !differ {
            return Err(self.too_few(found.len(), "value"));
        }
        let (values, soils): (Vec<f64>, Vec<&'static str>) = found.into_iter().unzip();
        let reason = format!(
            "published for {} soils of the kind `{}`; each step between neighbouring values has the same probability",
            soils.len(),
            self.kind
        );
        Ok(SpreadValue { field: parameter.name, values, soils, reason })
    }

    fn spread_of_law(&self) -> Result<SpreadLaw, String> {
        if self.pressure_sinkage().is_none() {
            return Err("the soil has no whole law of its own".to_owned());
        }
        let law = self.law.as_deref().and_then(PressureSinkage::named).ok_or("the soil has no law")?;
        let required: Vec<&'static Parameter> = law.parameters.iter().filter(|parameter| parameter.is_required()).collect();
        let row = |other: &'static Self| {
            let values: Option<Vec<f64>> =
                required.iter().map(|parameter| founded(&other.values, other.grade, parameter.name)).collect();
            Some((values?, other.id.as_str()))
        };
        let (rows, soils): (Vec<Vec<f64>>, Vec<&'static str>) =
            self.of_kind().filter(|other| other.law == self.law).filter_map(row).unzip();
        if rows.iter().all(|row| Some(row) == rows.first()) {
            return Err(self.too_few(rows.len(), "law"));
        }
        let reason = format!(
            "the laws `{}` of {} soils of the kind `{}`, each as likely and taken as a whole, because moduli belong to their exponent",
            law.name,
            soils.len(),
            self.kind
        );
        let columns = (0..required.len()).map(|i| rows.iter().map(|row| row[i]).collect()).collect();
        let parameters = required.iter().map(|parameter| parameter.name).collect();
        Ok(SpreadLaw { parameters, columns, soils, reason })
    }

    fn too_few(&self, count: usize, what: &str) -> String {
        let kind = &self.kind;
        match count {
            0 => format!("no soil of the kind `{kind}` has a published {what} of its own"),
            1 => format!("only one soil of the kind `{kind}` has a published {what} of its own"),
            count => format!("the {count} soils of the kind `{kind}` that publish a {what} have the same"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::soil;

    fn spread(id: &str) -> Spread {
        soil(id).expect("a soil").spread()
    }

    /// Cohesions of snow as in the catalogue, by hand.
    #[test]
    fn values_of_a_kind_spread_with_their_soils() {
        let spread = spread("wong-snow-us");
        let cohesion = spread.values.iter().find(|value| value.field == "cohesion_pa").expect("a spread of the cohesion");
        assert_eq!(cohesion.values, [500.0, 620.0, 1030.0, 1200.0, 6000.0]);
        assert_eq!(cohesion.soils[0], "lever-snow");
        assert_eq!(cohesion.soils[4], "wong-snow-sweden");
        let law = spread.law.expect("a spread of the law");
        assert_eq!(law.parameters, ["k_c", "k_phi", "n0"]);
        let row = law.soils.iter().position(|soil| *soil == "wong-snow-harrison").expect("a row");
        assert_eq!([law.columns[0][row], law.columns[1][row], law.columns[2][row]], [2490.0, 245_900.0, 1.6]);
    }

    /// Of three shear moduli of snow two are guesses, and most laws of Martian soils are those of lunar ones.
    #[test]
    fn what_was_assigned_from_elsewhere_does_not_spread() {
        let snow = spread("wong-snow-us");
        let held: Vec<&Held> = snow.held.iter().collect();
        assert_eq!((held.len(), held[0].field), (1, "shear_modulus_m"));
        assert!(held[0].reason.starts_with("only one soil of the kind `snow`"), "{held:?}");
        assert_eq!(spread("mars-vl1-drift").law, None);
    }

    #[test]
    fn a_soil_alone_in_its_kind_has_no_spread() {
        let alone = spread("letter-sand");
        assert!(alone.values.is_empty() && alone.law.is_none());
        assert_eq!(alone.held.len(), 4);
    }
}
