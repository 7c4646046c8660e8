//! How the cells of a series become samples.

use terramechanics::{KnownSinkage, Measured, NormalStressFrom, Sample, SampleMotion, Sinkage, Velocities};
use terramechanics_reading::Scope;

use crate::request::sinkage::of_known;
use crate::series::{Cells, Column, Layout};

/// How the cells of a series become samples.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TrackPlan {
    pub(super) layout: Layout,
    pub(super) from_static: Option<KnownSinkage>,
    pub(super) normal_load: Option<f64>,
}

/// What is given or asked for beside the columns.
#[derive(Debug, Clone, Copy)]
pub(super) struct BesideColumns {
    pub(super) static_sinkage: bool,
    pub(super) normal_load: bool,
    pub(super) strength: bool,
    /// Whether there is a soil, right or wrong.
    pub(super) soil: bool,
    /// Whether the soil has a pressure–sinkage law; true where the soil is wrong in another way.
    pub(super) law: bool,
}

/// Whether samples with these columns can be followed; what is wrong with the columns is reported.
pub(super) fn check_columns(layout: Layout, beside: BesideColumns, place: &Scope<'_>) -> bool {
    let BesideColumns { static_sinkage, normal_load, strength, soil, law } = beside;
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
    let known_sinkage = static_sinkage || has(Column::Sinkage);
    if !known_sinkage && !normal_load {
        refuse(place.field("static_sinkage_m"), "is required, or `normal_load_n`, or a column `sinkage_m`");
    }
    if !(soil || known_sinkage && normal_load && has(Column::Torque)) {
        let detail = "is required, unless torque, load and a sinkage are known: a column `torque_n_m`, `normal_load_n` and \
                      `sinkage_m` or `static_sinkage_m`";
        refuse(place.field("soil"), detail);
    }
    if soil && !(law || known_sinkage && normal_load) {
        let detail = "is required, unless the load is known beside the sinkage";
        refuse(place.field("soil").field("pressure_sinkage"), detail);
    }
    sound
}

impl TrackPlan {
    /// Whether there is a column for the pull by the coupled form.
    pub(crate) fn is_coupled(&self) -> bool {
        self.layout.has(Column::Torque)
    }

    /// What the normal stress of the samples follows from.
    pub(crate) fn normal_stress_from(&self) -> NormalStressFrom {
        let is_known = self.from_static.is_some() || self.layout.has(Column::Sinkage);
        let has_load = self.normal_load.is_some() || self.layout.has(Column::NormalLoad);
        if is_known && has_load { NormalStressFrom::Load } else { NormalStressFrom::Soil }
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
        let measured = self.layout.has(Column::Sinkage).then(|| KnownSinkage::Given(cell(Column::Sinkage)));
        let sinkage = match measured.or(self.from_static) {
            Some(known) => of_known(known, load),
            None => Sinkage::CarryingLoad(load.unwrap_or(f64::NAN)),
        };
        let torque = self.is_coupled().then(|| cell(Column::Torque));
        let measured = torque.zip(load).map(|(torque, normal_load)| Measured { torque, normal_load });
        Sample { time: cell(Column::Time), motion, sinkage, measured, unreadable: false }
    }
}
