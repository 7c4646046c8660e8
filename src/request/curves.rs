//! The requests of `/v1/identify/plates` and `/v1/identify/shear`: lists of curves.

use terramechanics_identification::{MOST_CURVES, MOST_PLATES, PlateCurve, PlatesError, ShearCurve, ShearError};

use super::Request;
use crate::wire::{Entry, FieldFault, List, ListSpec, Nested, Number, Object, Scope, Series, SeriesSpec, wire_object};

const SINKAGE: Number = Number::new("Sinkage z (m).", 0.0, 100.0);
const PRESSURE: Number = Number::new("Pressure p (Pa).", 0.0, 1e12);
const DISPLACEMENT: Number = Number::new("Shear displacement j (m).", 0.0, 100.0);
const SHEAR: Number = Number::new("Shear stress τ (Pa).", -1e12, 1e12);

const fn column(doc: &'static str, number: Number) -> SeriesSpec {
    SeriesSpec { doc, number, fewest: 1, required: true }
}

wire_object! {
    /// Pressure over sinkage, as columns of one length. Rows without sinkage tell nothing of a power of it and are left out; of the others, one at least has to have a pressure.
    PlateColumnsDto as "PlateColumns" {
        sinkage_m: Series = column("Sinkage z (m).", SINKAGE),
        pressure_pa: Series = column("Pressure p (Pa).", PRESSURE),
    }
}

wire_object! {
    /// A plate and what was measured under it.
    PlateDto as "Plate" {
        width_m: f64 = Number::new("Smaller side, or radius of a round plate, b (m).", 1e-3, 100.0).required(),
        columns: PlateColumnsDto = Nested::required("The measured curve."),
    }
}

wire_object! {
    /// Curves of two or more plates of different width.
    PlatesDto as "PlatesRequest" {
        plates: List<PlateDto> = ListSpec::required("The plates, of at least two widths.", 2, MOST_PLATES),
    }
}

wire_object! {
    /// Shear stress over displacement, as columns of one length.
    ShearColumnsDto as "ShearColumns" {
        displacement_m: Series = column("Shear displacement j (m).", DISPLACEMENT),
        shear_stress_pa: Series = column("Shear stress τ (Pa).", SHEAR),
    }
}

wire_object! {
    /// A shear test under one normal stress.
    ShearCurveDto as "ShearCurve" {
        normal_stress_pa: f64 = Number::new("Normal stress σ (Pa).", 0.0, 1e12).required(),
        columns: ShearColumnsDto = Nested::required("The measured curve."),
    }
}

wire_object! {
    /// Shear tests under two or more normal stresses.
    ShearTestsDto as "ShearTestsRequest" {
        curves: List<ShearCurveDto> = ListSpec::required("The tests, under at least two normal stresses.", 2, MOST_CURVES),
    }
}

/// Two columns of one length.
fn pair(first: &Entry<'_, Series>, second: &Entry<'_, Series>, place: &Scope<'_>) -> Option<(Vec<f64>, Vec<f64>)> {
    let (values, others) = (first.required_numbers(place), second.required_numbers(place));
    let (values, others) = (values?, others?);
    if values.len() != others.len() {
        let (found, expected) = (others.len(), values.len());
        place.field(second.name).fault(format_args!("has {found} values where `{}` has {expected}", first.name));
        return None;
    }
    Some((values, others))
}

impl PlateDto {
    /// The curve, and how many rows without sinkage were left out of it.
    fn check(&self, place: &Scope<'_>) -> Option<(PlateCurve, usize)> {
        self.report_oddities(place);
        let width = self.width_m().required_number(place);
        let around = place.field("columns");
        let columns = self.columns().required(place).and_then(|columns| {
            columns.report_oddities(&around);
            pair(&columns.sinkage_m(), &columns.pressure_pa(), &around)
        });
        let (sinkage, pressure): (Vec<f64>, Vec<f64>) = columns?;
        let rows = sinkage.len();
        let (sinkage, pressure): (Vec<f64>, Vec<f64>) = sinkage.into_iter().zip(pressure).filter(|(z, _)| *z > 0.0).unzip();
        if sinkage.is_empty() {
            around.field("sinkage_m").fault("has no value greater than 0");
            return None;
        }
        let left_out = rows - sinkage.len();
        Some((PlateCurve { width: width?, sinkage, pressure }, left_out))
    }
}

impl ShearCurveDto {
    fn check(&self, place: &Scope<'_>) -> Option<ShearCurve> {
        self.report_oddities(place);
        let normal = self.normal_stress_pa().required_number(place);
        let around = place.field("columns");
        let columns = self.columns().required(place).and_then(|columns| {
            columns.report_oddities(&around);
            pair(&columns.displacement_m(), &columns.shear_stress_pa(), &around)
        });
        let (displacement, shear) = columns?;
        Some(ShearCurve { normal: normal?, displacement, shear })
    }
}

/// Plate tests, checked.
pub(crate) struct PlatesQuery {
    pub(crate) curves: Vec<PlateCurve>,
    /// Rows without sinkage.
    pub(crate) left_out: usize,
}

/// Shear tests, checked.
pub(crate) struct ShearTestsQuery(pub(crate) Vec<ShearCurve>);

impl Request for PlatesDto {
    type Query = PlatesQuery;

    fn check(&self, place: &Scope<'_>) -> Option<PlatesQuery> {
        let checked = self.plates().each(place, PlateDto::check)?;
        let left_out = checked.iter().map(|(_, left_out)| left_out).sum();
        Some(PlatesQuery { curves: checked.into_iter().map(|(curve, _)| curve).collect(), left_out })
    }
}

impl Request for ShearTestsDto {
    type Query = ShearTestsQuery;

    fn check(&self, place: &Scope<'_>) -> Option<ShearTestsQuery> {
        self.curves().each(place, ShearCurveDto::check).map(ShearTestsQuery)
    }
}

/// What plate tests whose fields are each right do not tell.
pub(crate) fn plates_fault(error: PlatesError) -> FieldFault {
    let pointer = match error {
        PlatesError::Curve(plate) | PlatesError::Size(plate) => format!("/plates/{plate}"),
        PlatesError::Count | PlatesError::OneWidth | PlatesError::OneSinkage | PlatesError::NotFinite | PlatesError::Stopped => {
            "/plates".to_owned()
        }
    };
    FieldFault { pointer, detail: error.to_string() }
}

/// What shear tests whose fields are each right do not tell.
pub(crate) fn shear_fault(error: ShearError) -> FieldFault {
    let pointer = match error {
        ShearError::Curve(curve) => format!("/curves/{curve}"),
        ShearError::Count
        | ShearError::OneStress
        | ShearError::NoShear
        | ShearError::Displacements
        | ShearError::Stresses
        | ShearError::NotFinite
        | ShearError::Stopped => "/curves".to_owned(),
    };
    FieldFault { pointer, detail: error.to_string() }
}
