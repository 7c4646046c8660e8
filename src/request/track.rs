//! The request of `/v1/track`.

use terramechanics::{Measured, Operation, Sample, SampleMotion, ShearLaw, Sinkage, Thresholds, Tracker, Velocities};
use terramechanics_identification::RunningStrength;

use super::method::MethodEntries;
use super::operation::{self, OperationEntries};
use super::series::Samples;
use super::soil::Needs;
use super::{ColumnsDto, ContactDto, Request, SlipSinkageDto, SoilDto, WheelDto, collected};
use crate::series::{Cells, Column, ExtraColumns, Layout};
use crate::wire::{Asked, AskedSpec, Choice, Entry, Field, FieldFault, Lambda, Nested, Number, Object, Scope, wire_object};

const NORMAL_LOAD: Number = Number::new(
    "Vertical load W (N), unless it is a column; the sinkage is solved so that F_z = W where it is neither measured nor static.",
    1e-9,
    1e12,
);

const EXTRA_COLUMNS: Choice = Choice {
    doc: "What becomes of columns that no sample has, such as the voltage of a battery: refuse names them all; ignore leaves them out, though the schema of the columns does not list them.",
    words: || vec!["refuse", "ignore"],
    default: Some("refuse"),
};

wire_object! {
    /// A wheel followed over time. The sinkage of a sample is the measured one if there is a column `sinkage_m`; else it follows from `static_sinkage_m`, or is solved for `normal_load_n`, of which one has to be given.
    TrackDto as "TrackRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        contact: ContactDto = operation::CONTACT,
        static_sinkage_m: f64 = operation::STATIC_SINKAGE,
        slip_sinkage: SlipSinkageDto = operation::SLIP_SINKAGE,
        normal_load_n: f64 = NORMAL_LOAD,
        method: String = operation::METHOD,
        braking: String = operation::BRAKING,
        normal_stress_radius: String = operation::NORMAL_STRESS_RADIUS,
        peak_sinkage: String = operation::PEAK_SINKAGE,
        lambda_a: Lambda = operation::LAMBDA_A,
        lambda_b: Lambda = operation::LAMBDA_B,
        thresholds: ThresholdsDto = Nested::optional("When the wheel counts as stuck."),
        strength: Asked<StrengthDto> = AskedSpec {
            doc: "Asks for a running estimate of cohesion and friction, for linear stresses, which bias both; true for its defaults. Needs the columns torque_n_m and sinkage_m, as measured, and a load.",
            object: Nested::optional("The running estimate."),
        },
        columns: ColumnsDto = Nested::required("The samples."),
        extra_columns: String = EXTRA_COLUMNS,
    }
}

wire_object! {
    /// A running estimate of the soil's strength by recursive least squares (Iagnemma et al. 2004), with its covariance.
    StrengthDto as "TrackStrength" {
        forgetting_factor: f64 = Number::new("Weight (–) that a sample keeps as the next one comes; 1 forgets none.", 0.5, 1.0).or(0.99),
    }
}

impl StrengthDto {
    /// The estimate before the first sample, for a wheel on a soil whose shear modulus is known.
    fn check(&self, operation: &Operation, place: &Scope<'_>) -> Option<RunningStrength> {
        self.report_oddities(place);
        let forgetting = self.forgetting_factor().or_default(place)?;
        if !matches!(operation.system.soil.shear(), Some(ShearLaw::JanosiHanamoto(_))) {
            place.fault("is known for the shear law janosi_hanamoto only");
            return None;
        }
        RunningStrength::new(operation.system, operation.model.normal_stress_radius, forgetting)
    }
}

wire_object! {
    /// When the wheel counts as stuck. The defaults are chosen for want of a published rule.
    ThresholdsDto as "TrackThresholds" {
        stall_slip: f64 = Number::of(&Thresholds::STALL_SLIP, "Slip (–) from which on the wheel may stall."),
        stall_time_s: f64 = Number::of(&Thresholds::STALL_TIME, "Time (s) for which the slip has to stay there."),
        entrapment_sinkage_ratio: f64 = Number::of(&Thresholds::ENTRAPMENT_SINKAGE_RATIO, "Share of the radius (–) beyond which the sinkage is an entrapment."),
    }
}

impl ThresholdsDto {
    fn check(&self, place: &Scope<'_>) -> Option<Thresholds> {
        self.report_oddities(place);
        let stall_slip = self.stall_slip().or_default(place);
        let stall_time = self.stall_time_s().or_default(place);
        let ratio = self.entrapment_sinkage_ratio().or_default(place);
        Some(Thresholds { stall_slip: stall_slip?, stall_time: stall_time?, entrapment_sinkage_ratio: ratio? })
    }
}

/// All of a request but the samples.
#[derive(Debug, Clone)]
pub(crate) struct TrackSettings {
    pub(crate) operation: Operation,
    /// The sinkage that follows from a static one.
    from_static: Option<Sinkage>,
    normal_load: Option<f64>,
    pub(crate) tracker: Tracker,
    /// The running estimate of the strength, where it is asked for.
    pub(crate) strength: Option<RunningStrength>,
    pub(crate) extra_columns: ExtraColumns,
}

/// How the cells of a series become samples.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TrackPlan {
    layout: Layout,
    from_static: Option<Sinkage>,
    normal_load: Option<f64>,
}

/// A run over samples in memory, checked.
pub(crate) struct TrackQuery {
    pub(crate) settings: TrackSettings,
    pub(crate) samples: Samples,
}

impl TrackDto {
    /// What becomes of columns that are not known; none where the word for it is wrong, which is reported.
    fn unknown_columns(&self, place: &Scope<'_>) -> Option<ExtraColumns> {
        let word = self.extra_columns();
        if !word.is_present() {
            return Some(ExtraColumns::Refuse);
        }
        word.looked_up(place, |word| match word {
            "refuse" => Some(ExtraColumns::Refuse),
            "ignore" => Some(ExtraColumns::Ignore),
            _ => None,
        })
    }

    /// All but the samples.
    pub(crate) fn settings(&self, place: &Scope<'_>) -> Option<TrackSettings> {
        const NONE: Field<f64> = Field::Absent;
        let entries = OperationEntries {
            wheel: self.wheel(),
            soil: self.soil(),
            needs: Needs::BOTH_LAWS,
            contact: self.contact(),
            sinkage: Entry { name: "sinkage_m", field: &NONE, spec: &operation::SINKAGE },
            static_sinkage: self.static_sinkage_m(),
            slip_sinkage: self.slip_sinkage(),
            normal_load: self.normal_load_n(),
            normal_stress_radius: self.normal_stress_radius(),
            peak_sinkage: self.peak_sinkage(),
            braking: self.braking(),
            side_slip: None,
            method: Some(MethodEntries { method: self.method(), lambda_a: self.lambda_a(), lambda_b: self.lambda_b() }),
        };
        let sound = |entry: Entry<'_, f64>| if entry.is_present() { entry.checked(place).map(Some) } else { Some(None) };
        let (static_sinkage, normal_load) = (sound(self.static_sinkage_m()), sound(self.normal_load_n()));
        let law = entries.slip_sinkage(place);
        // Every sample brings a sinkage of its own; this one only says of what kind most of them are.
        let kind = if self.normal_load_n().is_present() { Sinkage::CarryingLoad(1.0) } else { Sinkage::Given(1.0) };
        let checked = entries.check_with(place, |_| Some(kind));
        let thresholds = self.thresholds();
        let thresholds = if thresholds.is_present() {
            thresholds.given(place).and_then(|dto| dto.check(&place.field(thresholds.name)))
        } else {
            Some(Thresholds::default())
        };
        let extra_columns = self.unknown_columns(place);
        let law = law?;
        let from_static = static_sinkage?.map(|static_sinkage| Sinkage::FromStatic { static_sinkage, law });
        let operation = Operation { sinkage: from_static.unwrap_or(kind), ..checked?.operation };
        let tracker = Tracker::new(operation, thresholds?).map_err(|invalid| place.fault(invalid)).ok()?;
        let strength = self.strength();
        let strength = if strength.is_present() {
            Some(strength.given(place)?.0.check(&operation, &place.field(strength.name))?)
        } else {
            None
        };
        Some(TrackSettings {
            operation,
            from_static,
            normal_load: normal_load?,
            tracker,
            strength,
            extra_columns: extra_columns?,
        })
    }
}

/// Whether samples with these columns can be followed; what is wrong with the columns is reported.
fn check_columns(layout: Layout, static_sinkage: bool, normal_load: bool, strength: bool, place: &Scope<'_>) -> bool {
    let columns = place.field("columns");
    let has = |column: Column| layout.has(column);
    let mut sound = true;
    let mut refuse = |place: Scope<'_>, detail: &str| {
        place.fault(detail);
        sound = false;
    };
    if !has(Column::Time) {
        refuse(columns.field(Column::Time.name()), "is required");
    }
    match (has(Column::Slip), has(Column::ForwardVelocity), has(Column::AngularVelocity)) {
        (true, false, false) | (false, true, true) => {}
        (true, ..) => refuse(columns.field(Column::Slip.name()), "give either `slip` or both velocities, not both"),
        (false, true, false) => refuse(columns.field(Column::AngularVelocity.name()), "is required with the other velocity"),
        (false, false, true) => refuse(columns.field(Column::ForwardVelocity.name()), "is required with the other velocity"),
        (false, false, false) => {
            refuse(columns.field(Column::Slip.name()), "is required, or both `forward_velocity_m_s` and `angular_velocity_rad_s`")
        }
    }
    if has(Column::NormalLoad) && normal_load {
        refuse(columns.field(Column::NormalLoad.name()), "is given beside the columns as well");
    }
    let normal_load = normal_load || has(Column::NormalLoad);
    if strength {
        // A sinkage that is modelled follows from the very soil that is sought.
        for column in [Column::Torque, Column::Sinkage].into_iter().filter(|&column| !has(column)) {
            refuse(columns.field(column.name()), "`strength` needs this column, as measured");
        }
        if !normal_load {
            refuse(
                columns.field(Column::NormalLoad.name()),
                "`strength` needs this column, or `normal_load_n` beside the columns",
            );
        }
    }
    // With a measured torque or sinkage each of the two has a meaning of its own.
    if static_sinkage && normal_load && !has(Column::Torque) && !has(Column::Sinkage) {
        refuse(place.field("static_sinkage_m"), "only one of `static_sinkage_m` and `normal_load_n` may be given");
    }
    if !has(Column::Sinkage) && !static_sinkage && !normal_load {
        refuse(place.field("static_sinkage_m"), "is required, or `normal_load_n`, or a column `sinkage_m`");
    }
    sound
}

impl TrackSettings {
    /// How samples with the columns of `layout` are understood; the faults are those of its columns.
    pub(crate) fn plan(&self, layout: Layout, place: &Scope<'_>) -> Option<TrackPlan> {
        let Self { from_static, normal_load, .. } = *self;
        check_columns(layout, from_static.is_some(), normal_load.is_some(), self.strength.is_some(), place).then_some(TrackPlan {
            layout,
            from_static,
            normal_load,
        })
    }
}

impl TrackPlan {
    /// Whether there is a column for the pull by the coupled form.
    pub(crate) fn is_coupled(&self) -> bool {
        self.layout.has(Column::Torque)
    }

    /// Whether a torque is measured and no load that would go with it is known.
    pub(crate) fn lacks_load(&self) -> bool {
        self.is_coupled() && self.normal_load.is_none() && !self.layout.has(Column::NormalLoad)
    }

    /// The sample in a row of cells.
    pub(crate) fn sample(&self, cells: &Cells) -> Sample {
        let cell = |column: Column| cells[column as usize];
        let load = if self.layout.has(Column::NormalLoad) { Some(cell(Column::NormalLoad)) } else { self.normal_load };
        let motion = if self.layout.has(Column::Slip) {
            SampleMotion::Slip(cell(Column::Slip))
        } else {
            SampleMotion::Velocities(Velocities {
                forward: cell(Column::ForwardVelocity),
                angular: cell(Column::AngularVelocity),
            })
        };
        let sinkage = if self.layout.has(Column::Sinkage) {
            Sinkage::Given(cell(Column::Sinkage))
        } else {
            self.from_static.unwrap_or(Sinkage::CarryingLoad(load.unwrap_or(f64::NAN)))
        };
        let torque = self.is_coupled().then(|| cell(Column::Torque));
        let measured = torque.zip(load).map(|(torque, normal_load)| Measured { torque, normal_load });
        Sample { time: cell(Column::Time), motion, sinkage, measured, unreadable: false }
    }
}

impl Request for TrackDto {
    type Query = TrackQuery;

    fn check(&self, place: &Scope<'_>) -> Option<TrackQuery> {
        let settings = self.settings(place);
        let columns = self.columns().required(place);
        let ignored = matches!(self.extra_columns().field, Field::Given(word) if word == "ignore");
        let extra = if ignored { ExtraColumns::Ignore } else { ExtraColumns::Refuse };
        let samples = columns.and_then(|columns| columns.check(extra, &place.field("columns")));
        if let Some(columns) = columns {
            let (static_sinkage, load) = (self.static_sinkage_m().is_present(), self.normal_load_n().is_present());
            check_columns(columns.layout(), static_sinkage, load, self.strength().is_present(), place);
        }
        Some(TrackQuery { settings: settings?, samples: samples? })
    }
}

/// The settings of a run whose samples come as a stream, or all their faults.
pub(crate) fn checked_settings(request: &Field<TrackDto>) -> Result<TrackSettings, Vec<FieldFault>> {
    collected(|root| match request {
        Field::Given(request) => {
            request.report_oddities(root);
            if request.columns().is_present() {
                root.field("columns").fault("the body has the samples");
            }
            request.settings(root)
        }
        _ => None,
    })
}
