//! How the cells of a series become samples.

use terramechanics::{Measured, Sample, SampleMotion, Sinkage, Velocities};
use terramechanics_reading::Scope;

use crate::series::{Cells, Column, Layout};

/// How the cells of a series become samples.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TrackPlan {
    pub(super) layout: Layout,
    pub(super) from_static: Option<Sinkage>,
    pub(super) normal_load: Option<f64>,
}

/// Whether samples with these columns can be followed; what is wrong with the columns is reported.
pub(super) fn check_columns(layout: Layout, static_sinkage: bool, normal_load: bool, strength: bool, place: &Scope<'_>) -> bool {
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
