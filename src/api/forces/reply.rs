//! The answer of `/v1/forces`.

use std::borrow::Cow;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use utoipa::openapi::schema::{ArrayBuilder, ObjectBuilder, SchemaType, Type};
use utoipa::openapi::{Ref, RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use super::found::FoundForces;
use crate::quantity::{About, Field, OfPoint, Part, Point, PointValue, object_of, point_rows, with_fields};
use crate::reply::{AnglesReply, Reply, method_name};
use crate::request::circles::{Counted, words};
use crate::warning::Warning;

/// Forces and torque on the wheel: the quantities of the point, each in its part of the object.
#[derive(Debug)]
pub(crate) struct ForcesReply {
    method: &'static str,
    circles: Counted,
    normal_stress_from: &'static str,
    angles: AnglesReply,
    quantities: Vec<(&'static About, Part)>,
    /// The value of each; NaN where it is undefined.
    values: Vec<f64>,
    warnings: Vec<Warning>,
}

impl From<FoundForces> for ForcesReply {
    fn from(found: FoundForces) -> Self {
        let FoundForces { operation, motion, point, warnings } = found;
        let at = Point::of(&operation.system, motion, &point);
        let is_there = |of: &OfPoint| at.forces.side.is_some() || !of.value.is_sideways();
        let rows = point_rows().filter(|(_, of)| is_there(of));
        let (quantities, values) = rows.map(|(about, of)| ((about, of.part), of.value.at(&at))).unzip();
        Self {
            method: method_name(&operation.model.method),
            circles: Counted::by(&operation.model.method, operation.system.contact.circles()),
            normal_stress_from: point.normal_stress_from.name(),
            angles: point.angles.into(),
            quantities,
            values,
            warnings,
        }
    }
}

impl ForcesReply {
    fn part(&self, part: Part) -> impl Iterator<Item = (&'static str, Option<f64>)> {
        let all = self.quantities.iter().zip(&self.values);
        all.filter(move |((_, of), _)| *of == part).map(|((about, _), value)| (about.name, value.is_finite().then_some(*value)))
    }
}

/// The four parts of the forces as an object of their own.
struct Parts<'a>(&'a ForcesReply);

impl Serialize for Parts<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.part(Part::Components))
    }
}

impl Serialize for ForcesReply {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for part in Part::ALL {
            match part {
                Part::Components => map.serialize_entry("components", &Parts(self))?,
                part => {
                    for (name, value) in self.part(part) {
                        map.serialize_entry(name, &value)?;
                    }
                }
            }
            if part == Part::Motion {
                let (shear_displacement_radius, slip_radius) = words(self.circles);
                map.serialize_entry("method", self.method)?;
                map.serialize_entry("shear_displacement_radius", &shear_displacement_radius)?;
                map.serialize_entry("slip_radius", slip_radius)?;
                map.serialize_entry("normal_stress_from", self.normal_stress_from)?;
                map.serialize_entry("angles", &self.angles)?;
            }
        }
        map.serialize_entry("warnings", &self.warnings)?;
        map.end()
    }
}

/// The fields of some parts, for the contract.
fn fields(is_wanted: impl Fn(Part) -> bool) -> Vec<Field> {
    let field = |(about, of): (&'static About, OfPoint)| Field {
        about,
        nullable: matches!(of.value, PointValue::OrNone(_) | PointValue::UnderLoad(_)),
        present: of.value.is_sideways().then_some("where a slip angle was sent"),
    };
    point_rows().filter(|(_, of)| is_wanted(of.part)).map(field).collect()
}

impl PartialSchema for ForcesReply {
    fn schema() -> RefOr<Schema> {
        let word = |meaning: &str| ObjectBuilder::new().schema_type(Type::String).description(Some(meaning));
        let circle =
            word("Circle on which the shear displacement was counted: shearing or rim; null where the method counts none.")
                .schema_type(SchemaType::from_iter([Type::String, Type::Null]));
        let words = [
            ("method", "The method by which the forces were found."),
            ("slip_radius", "Circle on which the slip was counted: rim, shearing or lug_tip."),
            (
                "normal_stress_from",
                "What the normal stress follows from: soil, its pressure–sinkage law, or load, which was known beside the sinkage.",
            ),
        ];
        let warnings = ArrayBuilder::new().items(Ref::from_schema_name(Warning::name()));
        let object = ObjectBuilder::new()
            .description(Some("Forces and torque on the wheel."))
            .property("angles", Ref::from_schema_name(AnglesReply::name()))
            .property("components", Ref::from_schema_name("Components"))
            .property("shear_displacement_radius", circle)
            .property("warnings", warnings);
        let object =
            ["angles", "components", "shear_displacement_radius", "warnings"].into_iter().fold(object, ObjectBuilder::required);
        let object =
            words.into_iter().fold(object, |object, (name, meaning)| object.property(name, word(meaning)).required(name));
        with_fields(object, &fields(|part| part != Part::Components), Field::number).into()
    }
}

impl ToSchema for ForcesReply {
    fn name() -> Cow<'static, str> {
        "Forces".into()
    }

    fn schemas(found: &mut Vec<(String, RefOr<Schema>)>) {
        const DOC: &str = "The four parts of the forces: F_x = traction − resistance, F_z = normal support + shear support.";
        let components = object_of(DOC, &fields(|part| part == Part::Components), Field::number);
        found.push(("Components".to_owned(), components.into()));
        found.push((AnglesReply::name().into_owned(), AnglesReply::schema()));
        found.push((Warning::name().into_owned(), Warning::schema()));
        Warning::schemas(found);
    }
}

impl Reply for ForcesReply {
    fn columns(&self) -> Vec<(Cow<'static, str>, &[f64])> {
        let all = self.quantities.iter().zip(self.values.chunks(1));
        all.filter(|((_, part), _)| part.is_column()).map(|((about, _), value)| (about.name.into(), value)).collect()
    }

    fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }
}
