//! The request of `/v1/track`.

use terramechanics::{
    Braking, KnownSinkage, Method, Operation, ShearLaw, Sinkage, Soil, SoilParams, Thresholds, Tracker, WheelOnSoil,
};
use terramechanics_identification::RunningStrength;
use terramechanics_reading::{
    Alternative, Either, Field, FieldFault, Node, Number, Object, OneOf, Reader, Unknown, Word, collected,
};

use super::plan::{self, BesideColumns, TrackPlan};
use super::samples::{self, COLUMNS, Samples};
use crate::request::assume::{ASSUME, accepted_by};
use crate::request::circles::{CIRCLES, Counted};
use crate::request::laws::field_or_default;
use crate::request::method::{self, BRAKING, BRAKING_FIELD, LAMBDAS, METHOD, METHOD_FIELD, STRESSES};
use crate::request::sinkage::{LOAD, SLIP_SINKAGE, STATIC_SINKAGE, law_beside_static, of_known};
use crate::request::soil::{FoundSoil, Needs};
use crate::request::system::{self, CONTACT, SOIL, WHEEL};
use crate::request::unused::{Reads, Unused};
use crate::request::{Accepted, Documented, Request, operation};
use crate::series::{ExtraColumns, Layout};
use crate::words::HINTS;

const OPTIONAL_SOIL: Field<&Object> = Field {
    meaning: "The soil; not needed where torque, load and a sinkage are known, from which the pull follows by linear stresses.",
    required: false,
    ..SOIL
};
const NORMAL_LOAD: Field<Number> = Field::new(
    WheelOnSoil::NORMAL_LOAD.name,
    "Vertical load W (N), unless it is a column. Beside a sinkage, measured or static, it takes the place of the soil's sinkage modulus; without one the sinkage is solved so that F_z = W.",
    LOAD,
);
const EXTRA_COLUMNS: Field<Word<ExtraColumns>> = Field::new(
    "extra_columns",
    "What becomes of columns that no sample has, such as the voltage of a battery: refuse names them all; ignore leaves them out, though the schema of the columns does not list them.",
    Word::new(&[("refuse", ExtraColumns::Refuse), ("ignore", ExtraColumns::Ignore)]).or(ExtraColumns::Refuse),
);
const COLUMNS_FIELD: Field<&Object> = Field::required("columns", "The samples.", &COLUMNS);

const FORGETTING: Field<Number> = Field::new(
    "forgetting_factor",
    "Forgetting factor (–): share of its weight that a sample keeps with each new one; 1 forgets nothing.",
    Number::new("1", 0.5, 1.0).or(0.99),
);
const STRENGTH_OBJECT: Object = Object {
    name: "TrackStrength",
    doc: "A running estimate of the soil's strength by recursive least squares (Iagnemma et al. 2004), with its covariance.",
    groups: &[&[&FORGETTING]],
};
const STRENGTH: Field<OneOf> = Field::new(
    "strength",
    "Asks for a running estimate of cohesion and friction, for linear stresses, which bias both; true for its defaults. Needs the columns torque_n_m and sinkage_m, as measured, and a load.",
    OneOf::new("an object or true", &[Alternative::Asked(&STRENGTH_OBJECT, "The running estimate.")]),
);

const STALL_SLIP: Field<Number> = field_or_default(&Thresholds::STALL_SLIP, "Slip (–) at or above which the wheel may stall.");
const STALL_TIME: Field<Number> = field_or_default(&Thresholds::STALL_TIME, "Time (s) for which the slip has to stay there.");
const ENTRAPMENT: Field<Number> =
    field_or_default(&Thresholds::ENTRAPMENT_SINKAGE_RATIO, "Sinkage over radius (–) above which the wheel counts as entrapped.");
const THRESHOLDS_OBJECT: Object = Object {
    name: "TrackThresholds",
    doc: "When the wheel counts as stuck. No published rule is known, so the defaults are a choice.",
    groups: &[&[&STALL_SLIP, &STALL_TIME, &ENTRAPMENT]],
};
const THRESHOLDS: Field<&Object> = Field::new("thresholds", "When the wheel counts as stuck.", &THRESHOLDS_OBJECT);

/// All of a request but the samples.
#[derive(Debug, Clone)]
pub(crate) struct TrackSettings {
    pub(crate) operation: Operation,
    /// Whether the forces follow from a soil, or from the torque.
    pub(crate) has_soil: bool,
    /// The sinkage that follows from a static one.
    from_static: Option<KnownSinkage>,
    normal_load: Option<f64>,
    pub(crate) tracker: Tracker,
    /// The running estimate of the strength, where it is asked for.
    pub(crate) strength: Option<RunningStrength>,
    pub(crate) extra_columns: ExtraColumns,
    /// The circles on which the method counts.
    pub(crate) circles: Counted,
    /// What was sent and is not read.
    pub(crate) unused: Unused,
}

/// A run over samples in memory, checked.
pub(crate) struct TrackCase {
    pub(crate) settings: TrackSettings,
    pub(crate) samples: Samples,
}

/// When the wheel counts as stuck.
fn thresholds(object: &Reader<'_>) -> Option<Thresholds> {
    let thresholds = object.or_empty(&THRESHOLDS)?;
    let stall_slip = thresholds.or_default(&STALL_SLIP);
    let stall_time = thresholds.or_default(&STALL_TIME);
    let ratio = thresholds.or_default(&ENTRAPMENT);
    Some(Thresholds { stall_slip: stall_slip?, stall_time: stall_time?, entrapment_sinkage_ratio: ratio? })
}

/// The estimate before the first sample, for a wheel on a soil whose shear modulus is known; none where it is not asked for.
fn strength(object: &Reader<'_>, operation: &Operation) -> Option<Option<RunningStrength>> {
    let Some(Either::Object(asked)) = object.optional(&STRENGTH)? else { return Some(None) };
    let forgetting = asked.or_default(&FORGETTING)?;
    if !matches!(operation.system.soil.shear(), Some(ShearLaw::JanosiHanamoto(_))) {
        asked.place().fault("is known for the shear law janosi_hanamoto only");
        return None;
    }
    RunningStrength::new(operation.system, operation.model.normal_stress_radius, forgetting).map(Some)
}

/// All but the samples.
fn settings(object: &Reader<'_>, extra_columns: Option<ExtraColumns>) -> Option<TrackSettings> {
    let (static_sinkage, normal_load) = (object.optional(&STATIC_SINKAGE), object.optional(&NORMAL_LOAD));
    let law = law_beside_static(object);
    // Every sample brings a sinkage of its own; this one only says of what kind most of them are.
    let kind = if object.has(&NORMAL_LOAD) { Sinkage::CarryingLoad(1.0) } else { Sinkage::Given(1.0) };
    // Which columns there are, and so whether the law is needed, may not be known yet: see the plan.
    let needs = method::needs(object);
    let needs = Needs { pressure_sinkage: false, perhaps_pressure_sinkage: needs.pressure_sinkage, ..needs };
    let has_soil = object.has(&OPTIONAL_SOIL);
    let bare = || Soil::new(SoilParams::BARE).ok().map(FoundSoil::bare);
    let system = if has_soil { system::read(object, needs) } else { system::read_on(object, bare(), needs) };
    let found = operation::read_with(object, system, |_, _| Some(kind), method::read);
    if !has_soil && !is_free_of_soil(object, found.operation.as_ref()) {
        return None;
    }
    if let (true, Some(method), Some(soil)) = (has_soil, &found.method, &found.soil)
        && !operation::has_its_law(object, method, soil)
    {
        return None;
    }
    let thresholds = thresholds(object);
    let law = law?;
    let from_static = static_sinkage?.map(|static_sinkage| KnownSinkage::FromStatic { static_sinkage, law });
    let operation = Operation { sinkage: from_static.map_or(kind, |known| of_known(known, None)), ..found.operation? };
    let tracker = Tracker::new(operation, thresholds?).map_err(|invalid| object.place().fault(invalid)).ok()?;
    let tracker = if has_soil { tracker } else { tracker.without_soil() };
    let strength = strength(object, &operation)?;
    let (normal_load, extra_columns) = (normal_load?, extra_columns?);
    let (method, system) = (&operation.model.method, &operation.system);
    // The columns may show a pull that follows from the torque, beside any method.
    let reads = if has_soil { Reads::by(method, false).and(Reads::FROM_TORQUE) } else { Reads::FROM_TORQUE };
    let reads = if strength.is_some() { reads.and(Reads::STRESSES) } else { reads };
    let circles = system.contact.circles();
    let circles = if strength.is_some() { circles.into() } else { Counted::by(method, circles) };
    let unused = Unused::of(object, reads, system);
    Some(TrackSettings { operation, has_soil, from_static, normal_load, tracker, strength, extra_columns, circles, unused })
}

/// Whether nothing is asked for that needs a soil, where there is none; what is, is reported.
fn is_free_of_soil(object: &Reader<'_>, operation: Option<&Operation>) -> bool {
    let has_method = object.has(&METHOD_FIELD);
    if has_method {
        object.place_of(&METHOD_FIELD).fault("needs a soil: without one the pull follows from the torque");
    }
    let has_two_zones = operation.is_some_and(|operation| operation.system.contact.braking() == Braking::TwoZone);
    if has_two_zones {
        object.place_of(&BRAKING_FIELD).fault("needs a soil, whose friction parts the two zones");
    }
    !has_method && !has_two_zones
}

pub(super) type TrackRequest = Documented<TrackCase>;

impl Request for TrackCase {
    const OBJECT: &'static Object = &Object {
        name: "TrackRequest",
        doc: "A wheel followed over time. The sinkage of a sample is the measured one if there is a column `sinkage_m`; else it follows from `static_sinkage_m`, or is solved for `normal_load_n`. Slip, `static_sinkage_m` and `normal_load_n` together are enough for pull and torque: the load then takes the place of the soil's sinkage modulus. With a measured torque as well no soil is needed: the pull then follows from the torque.",
        groups: &[
            &[&WHEEL, &OPTIONAL_SOIL, &CONTACT, &ASSUME],
            CIRCLES,
            &[&STATIC_SINKAGE, &SLIP_SINKAGE, &NORMAL_LOAD],
            METHOD,
            BRAKING,
            STRESSES,
            LAMBDAS,
            &[&THRESHOLDS, &STRENGTH, &COLUMNS_FIELD, &EXTRA_COLUMNS],
        ],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let extra = object.or_default(&EXTRA_COLUMNS);
        let settings = settings(object, extra);
        let unknown = if extra == Some(ExtraColumns::Ignore) { Unknown::Ignored } else { Unknown::Refused };
        let columns = object.opened(&COLUMNS_FIELD, unknown);
        if let Some(None) = columns {
            object.place_of(&COLUMNS_FIELD).fault("is required");
        }
        let columns = columns.flatten()?;
        let samples = samples::read(&columns);
        let beside = BesideColumns {
            static_sinkage: object.has(&STATIC_SINKAGE),
            normal_load: object.has(&NORMAL_LOAD),
            strength: object.has(&STRENGTH),
            soil: object.has(&OPTIONAL_SOIL),
            law: settings.as_ref().is_none_or(TrackSettings::has_law),
        };
        plan::check_columns(samples::layout(&columns), beside, object.place());
        Some(Self { settings: settings?, samples: samples? })
    }
}

/// The settings of a run whose samples come as a stream, or all their faults.
pub(crate) fn checked_settings(query: &Node<'_>) -> Result<Accepted<TrackSettings>, Vec<FieldFault>> {
    accepted_by(query, TrackCase::OBJECT, |object| {
        if object.has(&COLUMNS_FIELD) {
            object.place_of(&COLUMNS_FIELD).fault("the body has the samples");
        }
        settings(object, object.or_default(&EXTRA_COLUMNS))
    })
}

impl TrackSettings {
    /// Whether the soil has the pressure–sinkage law, if the method has one.
    fn has_law(&self) -> bool {
        self.operation.model.method == Method::ResistiveForce || self.operation.system.soil.pressure_sinkage().is_some()
    }

    /// How samples with the columns of `layout` are understood.
    ///
    /// # Errors
    /// The faults of its columns.
    pub(crate) fn plan(&self, layout: Layout) -> Result<TrackPlan, Vec<FieldFault>> {
        let Self { from_static, normal_load, strength, .. } = self;
        let beside = BesideColumns {
            static_sinkage: from_static.is_some(),
            normal_load: normal_load.is_some(),
            strength: strength.is_some(),
            soil: self.has_soil,
            law: self.has_law(),
        };
        collected(&HINTS, |place| {
            plan::check_columns(layout, beside, place).then_some(TrackPlan {
                layout,
                from_static: *from_static,
                normal_load: *normal_load,
            })
        })
    }
}
