//! Measured columns and their standard deviations.

use terramechanics::{Error, Slip, Wheel};
use terramechanics_identification::{Column, Observations, Quantity};
use terramechanics_reading::{Alternative, Either, Field, Number, Numbers, Object, OneOf, Reader};

use crate::request::motion::RATIO;
use crate::request::sinkage::meant_in_metres;
use crate::request::sinkage_figures;

/// Numbers that a column has at most.
const MOST: usize = 10_001;
const LARGEST: f64 = 1e12;

const fn column(name: &'static str, meaning: &'static str, number: Number) -> Field<Numbers> {
    Field::new(name, meaning, Numbers::new(number, 1, MOST))
}

const fn measured(unit: &'static str) -> Number {
    Number::new(unit, -LARGEST, LARGEST)
}

const SLIP: Field<Numbers> = Field { required: true, ..column("slip", "Slip ratio s (–).", RATIO) };
/// In the order of the quantities.
const COLUMNS: [Field<Numbers>; 4] = [
    column("sinkage_m", "Sinkage z (m), at most the wheel's radius.", Number::new("m", 1e-9, 100.0)),
    column("longitudinal_force_n", "Longitudinal force F_x (N).", measured("N")),
    column("normal_force_n", "Normal force F_z (N); greater than 0 where it is the load.", measured("N")),
    column("torque_n_m", "Torque T (N·m).", measured("N.m")),
];
pub(super) const LOAD: Field<Numbers> = column(
    "normal_load_n",
    "Load W (N) that is known beside `sinkage_m`, in place of `normal_force_n`: it takes the place of the sinkage modulus, so that the closed forms need no pressure–sinkage law.",
    Number::new("N", 1e-9, LARGEST),
);
pub(super) const SINKAGE: Field<Numbers> = COLUMNS[0];
pub(super) const NORMAL: Field<Numbers> = COLUMNS[2];

const fn deviation(column: &Field<Numbers>, meaning: &'static str, either: &'static [Alternative]) -> Field<OneOf> {
    Field::new(column.name, meaning, OneOf::new("a number or an array of numbers", either))
}

const fn either(unit: &'static str) -> [Alternative; 2] {
    let number = Number::new(unit, 1e-12, LARGEST);
    [Alternative::Number(number), Alternative::Numbers(Numbers::new(number, 1, MOST))]
}

const DEVIATIONS: [Field<OneOf>; 4] = [
    deviation(&COLUMNS[0], "Of the sinkage (m).", &either("m")),
    deviation(&COLUMNS[1], "Of the longitudinal force (N).", &either("N")),
    deviation(&COLUMNS[2], "Of the normal force (N).", &either("N")),
    deviation(&COLUMNS[3], "Of the torque (N·m).", &either("N.m")),
];

const DATA_OBJECT: Object = Object {
    name: "FitData",
    doc: "Measurements as columns of one length. With `sinkage_m` the forces are predicted at the measured slip and sinkage; without it `normal_force_n` is the load, for which the sinkage is solved. With `sinkage_m` and `normal_load_n` both are known.",
    groups: &[&[&SLIP], &[&COLUMNS[0], &COLUMNS[1], &COLUMNS[2], &COLUMNS[3], &LOAD]],
};
pub(super) const DATA: Field<&Object> = Field::required("data", "What was measured.", &DATA_OBJECT);
const DEVIATIONS_OBJECT: Object = Object {
    name: "FitDeviations",
    doc: "Standard deviations of the measured columns, one for all rows or one each: of every fitted column, or of none. Only their ratios count: one factor common to all is estimated from the residuals, as by `absolute_sigma=False` of SciPy's `curve_fit`.",
    groups: &[&[&DEVIATIONS[0], &DEVIATIONS[1], &DEVIATIONS[2], &DEVIATIONS[3]]],
};
pub(super) const STANDARD_DEVIATION: Field<&Object> = Field::new(
    "standard_deviation",
    "Standard deviations; without them every column counts by its size. By least_squares only their ratios count: the errors follow from the residuals. A robust loss takes the residuals in units of them.",
    &DEVIATIONS_OBJECT,
);

/// The name of a measured column.
pub(crate) fn column_name(quantity: Quantity) -> &'static str {
    let column = match quantity {
        Quantity::Sinkage => 0,
        Quantity::Longitudinal => 1,
        Quantity::Normal => 2,
        Quantity::Torque => 3,
    };
    COLUMNS[column].name
}

/// The measurements: all columns as long as the slip, no sinkage beyond the wheel.
pub(super) fn read(data: &Reader<'_>, deviations: Option<&Reader<'_>>, wheel: Option<&Wheel>) -> Option<Observations> {
    let slip = data.required(&SLIP);
    let columns = COLUMNS.each_ref().map(|field| data.optional(field));
    let load = data.optional(&LOAD);
    let slip = slip?;
    let mut is_whole = load_stands_alone(data);
    for (field, column) in COLUMNS.iter().chain([&LOAD]).zip(columns.iter().chain([&load])) {
        let Some(column) = column else {
            is_whole = false;
            continue;
        };
        if let Some(column) = column
            && column.len() != slip.len()
        {
            let (found, expected) = (column.len(), slip.len());
            data.place_of(field).fault(format_args!("has {found} values where `slip` has {expected}"));
            is_whole = false;
        }
    }
    let stated = match deviations {
        Some(deviations) => standard_deviations(deviations, data, slip.len()),
        None => Some(Default::default()),
    };
    let columns = columns.map(Option::flatten);
    let within = sinkages_within(data, columns[0], wheel);
    let mut stated = stated?;
    if !(is_whole && within) {
        return None;
    }
    let [sinkage, longitudinal, normal, torque] = columns;
    let normal = normal.or(load.flatten());
    let mut with =
        |i: usize, values: Option<&[f64]>| values.map(|values| Column { values: values.to_vec(), deviation: stated[i].take() });
    Some(Observations {
        slip: slip.iter().map(|&slip| Slip::new(slip)).collect::<Result<_, _>>().ok()?,
        sinkage: with(0, sinkage),
        longitudinal: with(1, longitudinal),
        normal: with(2, normal),
        torque: with(3, torque),
    })
}

/// Whether a load that is known stands beside a sinkage, and beside no normal force.
fn load_stands_alone(data: &Reader<'_>) -> bool {
    if data.has(&LOAD) && data.has(&NORMAL) {
        data.place_of(&LOAD).fault("stands in place of `normal_force_n`; give one of them");
        return false;
    }
    if data.has(&LOAD) && !data.has(&SINKAGE) {
        data.place_of(&LOAD).fault("needs `sinkage_m` beside it; a load for which the sinkage is solved is `normal_force_n`");
        return false;
    }
    true
}

/// Whether no sinkage is beyond the wheel; the first that is, is reported.
fn sinkages_within(data: &Reader<'_>, sinkages: Option<&[f64]>, wheel: Option<&Wheel>) -> bool {
    let (Some(sinkages), Some(wheel)) = (sinkages, wheel) else { return true };
    let radius = wheel.radius();
    let Some(row) = sinkages.iter().position(|&sinkage| sinkage > radius) else { return true };
    let figures = sinkage_figures(sinkages[row], radius);
    let error = Error::SinkageOutsideWheel { sinkage: sinkages[row], radius };
    let meant = meant_in_metres(sinkages[row], radius);
    data.place_of(&SINKAGE).item(row).report(figures, format_args!("{error}{meant}"));
    false
}

/// The deviations of sinkage, F_x, F_z and T; one of a column that was not measured is reported.
fn standard_deviations(object: &Reader<'_>, data: &Reader<'_>, count: usize) -> Option<[Option<Vec<f64>>; 4]> {
    let mut is_whole = true;
    let values = std::array::from_fn(|i| {
        let field = &DEVIATIONS[i];
        let values = match object.optional(field) {
            Some(None) => return None,
            Some(Some(Either::Number(value))) => Some(vec![value; count]),
            Some(Some(Either::Numbers(values))) if values.len() == count => Some(values.to_vec()),
            Some(Some(Either::Numbers(values))) => {
                let detail = format_args!("has {} values where the data have {count}", values.len());
                object.place_of(field).fault(detail);
                None
            }
            _ => None,
        };
        let is_measured = data.has(&COLUMNS[i]);
        if !is_measured {
            object.place_of(field).fault("has no such column in `data`");
        }
        is_whole &= values.is_some() && is_measured;
        values
    });
    is_whole.then_some(values)
}
