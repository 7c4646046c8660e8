//! The request of `/v1/compare`.

use serde::de::{IgnoredAny, SeqAccess};
use terramechanics::{ForceModel, Operation, Slip};
use utoipa::openapi::schema::ArrayBuilder;
use utoipa::openapi::{RefOr, Schema};

use super::axis::{SlipAxis, SlipAxisSpec};
use super::operation::{self, MethodEntries, OperationEntries};
use super::{ContactDto, Request, SlipSinkageDto, SoilDto, WheelDto};
use crate::wire::{Entry, Field, Lambda, Scope, Spec, Wire, wire_object};

/// Names of methods as they were sent.
#[derive(Debug, Clone)]
pub(crate) struct Methods(Vec<Field<String>>);

/// One to three different methods.
pub(crate) struct MethodsSpec;

/// More names than there are methods.
const MOST: usize = 3;

impl Spec for MethodsSpec {
    fn schema(&self) -> RefOr<Schema> {
        ArrayBuilder::new()
            .description(Some("The methods to compare, all different; the others are compared with the first."))
            .items(operation::METHOD_OF_SEVERAL.schema())
            .min_items(Some(1))
            .max_items(Some(MOST))
            .unique_items(true)
            .default(Some(serde_json::json!((operation::METHOD_OF_SEVERAL.words)())))
            .into()
    }
}

impl Wire for Methods {
    type Spec = MethodsSpec;
    const EXPECTED: &'static str = "an array of names of methods";

    fn list<'de, A: SeqAccess<'de>>(mut list: A) -> Result<Option<Self>, A::Error> {
        let mut names = Vec::new();
        while names.len() <= MOST {
            match list.next_element()? {
                Some(name) => names.push(name),
                None => return Ok(Some(Self(names))),
            }
        }
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Some(Self(names))) // one more than allowed, which the check refuses
    }
}

wire_object! {
    /// The forces over a range or a list of slips by several methods at once. The fields are those of a slip sweep, with `methods` for `method`.
    CompareDto as "CompareRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        contact: ContactDto = operation::CONTACT,
        slip: SlipAxis = SlipAxisSpec,
        sinkage_m: f64 = operation::SINKAGE,
        static_sinkage_m: f64 = operation::STATIC_SINKAGE,
        slip_sinkage: SlipSinkageDto = operation::SLIP_SINKAGE,
        normal_load_n: f64 = operation::NORMAL_LOAD,
        methods: Methods = MethodsSpec,
        normal_stress_radius: String = operation::NORMAL_STRESS_RADIUS,
        peak_sinkage: String = operation::PEAK_SINKAGE,
        braking: String = operation::BRAKING,
        lambda_a: Lambda = operation::LAMBDA_A,
        lambda_b: Lambda = operation::LAMBDA_B,
    }
}

/// A comparison, checked: the operations by method, of which there is at least one.
pub(crate) struct CompareQuery {
    pub(crate) operations: Vec<Operation>,
    pub(crate) slips: Vec<Slip>,
}

impl Request for CompareDto {
    type Query = CompareQuery;

    fn check(&self, place: &Scope<'_>) -> Option<CompareQuery> {
        let checked = OperationEntries {
            wheel: self.wheel(),
            soil: self.soil(),
            contact: self.contact(),
            sinkage: self.sinkage_m(),
            static_sinkage: self.static_sinkage_m(),
            slip_sinkage: self.slip_sinkage(),
            normal_load: self.normal_load_n(),
            normal_stress_radius: self.normal_stress_radius(),
            peak_sinkage: self.peak_sinkage(),
            braking: self.braking(),
            method: None,
            side_slip: None,
        }
        .check(place);
        let slips = self.slip().slips(place);
        let names = self.method_names(place);
        let checked = checked?;
        let model = |name: &Field<String>| {
            let method = Entry { name: "method", field: name, spec: &operation::METHOD };
            let entries = MethodEntries { method, lambda_a: self.lambda_a(), lambda_b: self.lambda_b() };
            let method = entries.check(place, checked.peak_depth)?;
            let contact = &checked.operation.system.contact;
            if !operation::takes_two_zones(method, contact, &self.braking(), place) {
                return None;
            }
            Some(Operation { model: ForceModel { method, ..checked.operation.model }, ..checked.operation })
        };
        let operations: Option<Vec<Operation>> = names?.iter().map(model).collect();
        Some(CompareQuery { operations: operations?, slips: slips? })
    }
}

impl CompareDto {
    /// The names of the methods, known and all different; all methods where none were sent.
    fn method_names(&self, place: &Scope<'_>) -> Option<Vec<Field<String>>> {
        let entry = self.methods();
        let known = (operation::METHOD_OF_SEVERAL.words)();
        if !entry.is_present() {
            return Some(known.into_iter().map(|name| Field::Given(name.to_owned())).collect());
        }
        let Methods(names) = entry.given(place)?;
        let list = place.field(entry.name);
        if !(1..=MOST).contains(&names.len()) {
            list.fault(format_args!("must name from 1 to {MOST} methods"));
            return None;
        }
        let mut found: Vec<Field<String>> = Vec::new();
        for (i, name) in names.iter().enumerate() {
            let item = list.item(i);
            match name {
                Field::Given(name) if !known.contains(&name.as_str()) => crate::wire::unknown_word(&item, name, &known),
                Field::Given(name) if found.iter().any(|earlier| matches!(earlier, Field::Given(other) if other == name)) => {
                    item.fault("is named more than once");
                }
                Field::Given(name) => found.push(Field::Given(name.clone())),
                Field::Wrong(kind) => item.fault(format_args!("must be a string, not {kind}")),
                Field::Absent => {}
            }
        }
        (found.len() == names.len()).then_some(found)
    }
}
