//! What the soil of a request weighs: its unit weight, density and granular stiffness, and the gravity in which it lies.

use terramechanics::{InvalidInput, STANDARD_GRAVITY, Soil, SoilParams};
use terramechanics_reading::{Field, Number, Reader};

use super::laws::own_field;
use super::preset::Preset;
use crate::catalogue::SoilRecord;

pub(super) const UNIT_WEIGHT: Field<Number> = own_field(&Soil::UNIT_WEIGHT);
pub(super) const BULK_DENSITY: Field<Number> = own_field(&Soil::BULK_DENSITY);
pub(super) const GRAVITY: Field<Number> = Field {
    meaning: "Gravity g (m/s²) in which the soil lies; that of the preset unless given, else the Earth's. Where it differs from that of a preset, the preset's weights follow it and its moduli do not.",
    ..own_field(&Soil::GRAVITY)
};
pub(super) const GRANULAR_STIFFNESS: Field<Number> = own_field(&Soil::GRANULAR_STIFFNESS);

/// What the grains of a soil weigh, and where.
pub(super) struct Weights {
    /// What was sent and, apart, what is published.
    unit_weight: [Option<f64>; 2],
    bulk_density: Option<f64>,
    gravity: [Option<f64>; 2],
    pub(super) granular_stiffness: Option<f64>,
}

impl Weights {
    pub(super) fn read(object: &Reader<'_>, preset: &Preset<SoilRecord>) -> Option<Self> {
        let unit_weight = object.optional(&UNIT_WEIGHT);
        let bulk_density = preset.optional(object, &BULK_DENSITY);
        let gravity = object.optional(&GRAVITY);
        let granular_stiffness = object.optional(&GRANULAR_STIFFNESS);
        // A unit weight that goes with another density follows from the density that was sent.
        let published = preset.entry.filter(|_| !object.has(&BULK_DENSITY));
        Some(Self {
            unit_weight: [unit_weight?, published.and_then(|record| record.number(UNIT_WEIGHT.name))],
            bulk_density: bulk_density?,
            gravity: [gravity?, preset.entry.and_then(SoilRecord::gravity)],
            granular_stiffness: granular_stiffness?,
        })
    }

    /// Unit weight (N/m³) for a law that has none of its own: the one that was sent, else that of the density here.
    pub(super) fn unit_weight(&self) -> Option<f64> {
        let [here, measured] = self.gravity;
        let gravity = here.or(measured).unwrap_or(STANDARD_GRAVITY);
        self.unit_weight[0].or_else(|| Some(self.bulk_density? * gravity))
    }

    /// The same with the start of a granular stiffness that is fitted and was not sent.
    pub(super) fn with_fitted(self, fitted: &dyn Fn(&str) -> Option<f64>) -> Self {
        Self { granular_stiffness: self.granular_stiffness.or_else(|| fitted(GRANULAR_STIFFNESS.name)), ..self }
    }

    /// The same with a density that may be assumed, where the granular stiffness needs one and none was published.
    pub(super) fn with_assumed_density(self, object: &Reader<'_>, preset: &Preset<SoilRecord>) -> Self {
        let needed = self.bulk_density.is_none() && self.granular_stiffness.is_none();
        let assumed = if needed { preset.assumed(object, &BULK_DENSITY) } else { None };
        Self { bulk_density: self.bulk_density.or(assumed), ..self }
    }

    /// The soil of `params` with these weights. What the catalogue has of it is taken to the gravity that was sent; what was sent
    /// holds there already.
    pub(super) fn soil(&self, params: SoilParams, has_published_law: bool) -> Result<Soil, InvalidInput> {
        let Self { unit_weight: [unit_weight, published], bulk_density, gravity: [here, measured], granular_stiffness } = *self;
        let params = SoilParams { bulk_density, granular_stiffness, ..params };
        let (Some(here), Some(measured)) = (here, measured) else {
            return Soil::new(SoilParams { unit_weight: unit_weight.or(published), gravity: here.or(measured), ..params });
        };
        let of_catalogue = Soil::new(SoilParams { unit_weight: published, gravity: Some(measured), ..params })?;
        let taken = *of_catalogue.in_gravity(here)?.params();
        let unit_weight = unit_weight.or(taken.unit_weight);
        let pressure_sinkage = if has_published_law { taken.pressure_sinkage } else { params.pressure_sinkage };
        let soil = Soil::new(SoilParams { unit_weight, pressure_sinkage, granular_stiffness, ..taken })?;
        Ok(if has_published_law { soil.measured_in(measured) } else { soil })
    }

    /// Whether a granular stiffness is there or follows; that it is not is reported.
    pub(super) fn are_enough(
        &self,
        object: &Reader<'_>,
        preset: &Preset<SoilRecord>,
        friction: (&Field<Number>, Option<f64>),
    ) -> bool {
        let bulk_density = self.bulk_density;
        if self.granular_stiffness.is_some() {
            return true;
        }
        if bulk_density.is_none() {
            preset.missing_or(object, &BULK_DENSITY, "; or give `granular_stiffness_n_m3`");
        }
        let is_smooth = friction.1 == Some(0.0);
        if is_smooth {
            let place = object.place_of(friction.0);
            place.fault(
                "must be greater than 0, because the granular stiffness follows from it; or give `granular_stiffness_n_m3`",
            );
        }
        bulk_density.is_some() && !is_smooth
    }
}
