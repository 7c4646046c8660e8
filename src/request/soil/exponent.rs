//! A sinkage exponent without moduli, which is enough where the load is known beside the sinkage.

use terramechanics::{Declared, Direct, Parameter, PressureSinkage, SinkageExponent};
use terramechanics_reading::{Base, Field, Number, Reader};

use super::{Needs, PRESSURE_SINKAGE};
use crate::catalogue::{SoilRecord, is_of_exponent};
use crate::request::laws;
use crate::request::preset::Preset;

/// The exponent that was sent, or else published, without the moduli of a law, where a load may take their place; nothing where what was
/// sent is wrong.
pub(super) fn alone(object: &Reader<'_>, preset: &Preset<SoilRecord>, needs: Needs<'_>) -> Option<Option<SinkageExponent>> {
    let has_law = preset.entry.is_some_and(|record| record.pressure_sinkage().is_some());
    if !needs.perhaps_pressure_sinkage || needs.pressure_sinkage || has_law || object.names_form(&PRESSURE_SINKAGE) {
        return Some(None);
    }
    let Some(sent) = object.within(&PRESSURE_SINKAGE) else {
        let nothing = !object.has(&PRESSURE_SINKAGE);
        return Some(preset.entry.filter(|_| nothing).and_then(published));
    };
    let all = PressureSinkage::LAWS.iter().flat_map(|law| law.parameters.iter());
    let mut moduli = all.filter(|parameter| !is_of_exponent(parameter.name));
    if moduli.any(|modulus| sent.has(&Field::new(modulus.name, "", Number::any("")))) {
        return Some(None);
    }
    // The exponent is read as that of the law whose modulus is a number by itself, here any: it goes no further.
    let value = |name: &str| {
        let published = preset.entry.and_then(|record| record.number(name)).filter(|_| is_of_exponent(name));
        published.or_else(|| (name == Direct::K_S.name).then_some(1.0))
    };
    let base = Base { form: Direct::NAME, value: &value };
    let chosen = object.chosen(&PRESSURE_SINKAGE, Some(&base), &|_| None)??;
    laws::pressure_sinkage(&chosen).map(|law| Some(law.exponent()))
}

/// The exponent of a soil whose moduli were not published.
fn published(record: &SoilRecord) -> Option<SinkageExponent> {
    let value = |parameter: &Parameter| record.number(parameter.name);
    let [base, slip_gain, skid_gain] =
        [&SinkageExponent::BASE, &SinkageExponent::SLIP_GAIN, &SinkageExponent::SKID_GAIN].map(value);
    Some(SinkageExponent { base: base?, slip_gain: slip_gain.unwrap_or(0.0), skid_gain })
}
