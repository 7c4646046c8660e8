//! Measured columns and their standard deviations.

use terramechanics::{Error, Slip, Wheel};
use terramechanics_identification::{Column, Observations, Quantity};

use crate::wire::{Each, EachSpec, Entry, Number, Object, Scope, Series, SeriesSpec, wire_object};

const FORCE: Number = Number::new("A measured value.", -1e12, 1e12);
const DEVIATION: Number = Number::new("A standard deviation, in the unit of the column.", 1e-12, 1e12);

const fn column(doc: &'static str, number: Number, required: bool) -> SeriesSpec {
    SeriesSpec { doc, number, fewest: 1, required }
}

const fn deviation(doc: &'static str) -> EachSpec {
    EachSpec(column(doc, DEVIATION, false))
}

wire_object! {
    /// Measurements as columns of one length. With `sinkage_m` the forces are predicted at the measured slip and sinkage; without it `normal_force_n` is the load, for which the sinkage is solved.
    DataDto as "FitData" {
        slip: Series = column("Slip ratio s (–).", Number::new("Slip ratio s (–).", -1.0, 1.0).share(), true),
        sinkage_m: Series = column("Sinkage z (m).", Number::new("Sinkage z (m), at most the wheel's radius.", 1e-9, 100.0), false),
        longitudinal_force_n: Series = column("Longitudinal force F_x (N).", FORCE, false),
        normal_force_n: Series = column("Normal force F_z (N); greater than 0 where it is the load.", FORCE, false),
        torque_n_m: Series = column("Torque T (N·m).", FORCE, false),
    }
}

wire_object! {
    /// Standard deviations of the measured columns, one for all rows or one each: of every fitted column, or of none. Only their ratios count: one factor common to all is estimated from the residuals, as by `absolute_sigma=False` of SciPy's `curve_fit`.
    DeviationsDto as "FitDeviations" {
        sinkage_m: Each = deviation("Of the sinkage (m)."),
        longitudinal_force_n: Each = deviation("Of the longitudinal force (N)."),
        normal_force_n: Each = deviation("Of the normal force (N)."),
        torque_n_m: Each = deviation("Of the torque (N·m)."),
    }
}

/// The name of a measured column.
pub(crate) fn column_name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Sinkage => "sinkage_m",
        Quantity::Longitudinal => "longitudinal_force_n",
        Quantity::Normal => "normal_force_n",
        Quantity::Torque => "torque_n_m",
    }
}

impl DataDto {
    fn columns(&self) -> [Entry<'_, Series>; 4] {
        [self.sinkage_m(), self.longitudinal_force_n(), self.normal_force_n(), self.torque_n_m()]
    }

    /// Whether a sinkage was sent, right or wrong.
    pub(super) fn has_sinkage(&self) -> bool {
        self.sinkage_m().is_present()
    }

    /// Whether a normal force was sent, right or wrong.
    pub(super) fn has_normal_force(&self) -> bool {
        self.normal_force_n().is_present()
    }

    /// The measurements: all columns as long as the slip, no sinkage beyond the wheel.
    pub(super) fn check(
        &self,
        place: &Scope<'_>,
        deviations: Option<(&DeviationsDto, &Scope<'_>)>,
        wheel: Option<&Wheel>,
    ) -> Option<Observations> {
        self.report_oddities(place);
        let slip = self.slip().required_numbers(place);
        let columns = self.columns().map(|entry| entry.numbers(place));
        let whole = self.columns().iter().zip(&columns).all(|(entry, column)| column.is_some() == entry.is_present());
        let stated = deviations.map(|(dto, place)| (dto, place, dto.report_oddities(place)));
        let slip = slip?;
        let mut long_enough = true;
        for (entry, column) in self.columns().iter().zip(&columns) {
            if let Some(column) = column
                && column.len() != slip.len()
            {
                let (found, expected) = (column.len(), slip.len());
                place.field(entry.name).fault(format_args!("has {found} values where `slip` has {expected}"));
                long_enough = false;
            }
        }
        let stated = stated.map(|(dto, place, ())| dto.check(place, self, slip.len()));
        let within = self.sinkages_within(place, columns[0].as_deref(), wheel);
        if !(whole && long_enough && within) {
            return None;
        }
        let mut stated = stated.map_or(Some(Default::default()), |stated| stated)?;
        let [sinkage, longitudinal, normal, torque] = columns;
        let mut with = |i: usize, values: Option<Vec<f64>>| values.map(|values| Column { values, deviation: stated[i].take() });
        Some(Observations {
            slip: slip.into_iter().map(Slip::new).collect::<Result<_, _>>().ok()?,
            sinkage: with(0, sinkage),
            longitudinal: with(1, longitudinal),
            normal: with(2, normal),
            torque: with(3, torque),
        })
    }

    /// Whether no sinkage is beyond the wheel; the first that is, is reported.
    fn sinkages_within(&self, place: &Scope<'_>, sinkages: Option<&[f64]>, wheel: Option<&Wheel>) -> bool {
        let (Some(sinkages), Some(wheel)) = (sinkages, wheel) else { return true };
        let radius = wheel.radius();
        let Some(row) = sinkages.iter().position(|&sinkage| sinkage > radius) else { return true };
        place.field("sinkage_m").item(row).fault(Error::SinkageOutsideWheel { sinkage: sinkages[row], radius });
        false
    }
}

impl DeviationsDto {
    /// The deviations of sinkage, F_x, F_z and T; one of a column that was not measured is reported.
    fn check(&self, place: &Scope<'_>, data: &DataDto, count: usize) -> Option<[Option<Vec<f64>>; 4]> {
        let entries = [self.sinkage_m(), self.longitudinal_force_n(), self.normal_force_n(), self.torque_n_m()];
        let mut whole = true;
        let values = std::array::from_fn(|i| {
            let entry = &entries[i];
            let values = entry.for_each_of(place, count);
            whole &= values.is_some() == entry.is_present();
            if entry.is_present() && !data.columns()[i].is_present() {
                place.field(entry.name).fault("has no such column in `data`");
                whole = false;
            }
            values
        });
        whole.then_some(values)
    }
}
