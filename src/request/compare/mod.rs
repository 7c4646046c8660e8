//! The request of `/v1/compare`.

mod variant;

use std::cell::RefCell;

use terramechanics::{ForceModel, Method, Operation, Slip};

use super::axis::{SlipOrAxis, SlipOrAxisSpec};
use super::method::{ClosedForms, checked_lambda, takes_two_zones};
use super::operation::{self, OperationEntries, operation_entries};
use super::{ContactDto, Request, SlipSinkageDto, SoilDto, WheelDto};
use crate::wire::{FieldFault, Lambda, List, Names, NamesSpec, Scope, wire_object};
use variant::VariantDto;

const METHODS: NamesSpec = NamesSpec {
    doc: "The methods to compare, all different; the other series are compared with that of the first.",
    word: operation::METHOD_OF_SEVERAL,
    most: 3,
    all_unless_given: true,
};

/// Operating points of all series, with those of the quadrature where it is not among the methods.
const MOST_POINTS: usize = 100_000;

wire_object! {
    /// The forces at one slip, or over a range or a list of slips, by several methods and laws at once. The fields are those of a slip sweep straight ahead, with `methods` for `method`; `slip` may be one number. Every method is applied to the request as it stands and to each of its `variants`; with all their series, and the quadrature where it is not among the methods, there may be 100000 operating points.
    CompareDto as "CompareRequest" {
        wheel: WheelDto = operation::WHEEL,
        soil: SoilDto = operation::SOIL,
        contact: ContactDto = operation::CONTACT,
        slip: SlipOrAxis = SlipOrAxisSpec,
        sinkage_m: f64 = operation::SINKAGE,
        static_sinkage_m: f64 = operation::STATIC_SINKAGE,
        slip_sinkage: SlipSinkageDto = operation::SLIP_SINKAGE,
        normal_load_n: f64 = operation::NORMAL_LOAD,
        methods: Names = METHODS,
        normal_stress_radius: String = operation::NORMAL_STRESS_RADIUS,
        peak_sinkage: String = operation::PEAK_SINKAGE,
        braking: String = operation::BRAKING,
        lambda_a: Lambda = operation::LAMBDA_A,
        lambda_b: Lambda = operation::LAMBDA_B,
        variants: List<VariantDto> = variant::VARIANTS,
    }
}

/// A comparison, checked.
pub(crate) struct CompareQuery {
    /// The request as it stands, then each of its variants.
    pub(crate) cases: Vec<Case>,
    pub(crate) slips: Vec<Slip>,
}

/// The operations by method, of which there is at least one, that differ in nothing else.
pub(crate) struct Case {
    /// The name of the variant; none of the request as it stands.
    pub(crate) variant: Option<String>,
    pub(crate) operations: Vec<Operation>,
}

impl Case {
    /// The quadrature of the case, where it is not among the operations.
    pub(crate) fn quadrature_beside(&self) -> Option<Operation> {
        let is_there = self.operations.iter().any(|operation| operation.model.method == Method::Quadrature);
        let first = self.operations.first().filter(|_| !is_there)?;
        Some(Operation { model: ForceModel { method: Method::Quadrature, ..first.model }, ..*first })
    }
}

impl CompareQuery {
    /// All operations that an answer takes.
    pub(crate) fn operations(&self) -> impl Iterator<Item = Operation> {
        self.cases.iter().flat_map(|case| case.operations.iter().copied().chain(case.quadrature_beside()))
    }
}

impl Request for CompareDto {
    type Query = CompareQuery;

    fn check(&self, place: &Scope<'_>) -> Option<CompareQuery> {
        let (own, faults) = self.operations();
        faults.iter().for_each(|fault| place.pass_on(fault.clone()));
        let slips = self.slip().slips(place);
        let mut names: Vec<String> = Vec::new();
        let variants = self.variants().each(place, |variant, place| {
            let name = variant.checked_name(place, &names);
            names.extend(name.clone());
            let operations = variant.operations(self, &faults, place);
            Some(Case { variant: Some(name?), operations: operations? })
        });
        let mut cases = vec![Case { variant: None, operations: own? }];
        cases.extend(variants?);
        let query = CompareQuery { cases, slips: slips? };
        let points = query.operations().count() * query.slips.len();
        if points > MOST_POINTS {
            let detail = format_args!(
                "all series, with the quadrature, have {points} operating points in all; {MOST_POINTS} is the most that is computed"
            );
            place.field(self.variants().name).fault(detail);
            return None;
        }
        Some(query)
    }
}

impl CompareDto {
    /// The operations by every method, and what is wrong with them; none only where something is.
    fn operations(&self) -> (Option<Vec<Operation>>, Vec<FieldFault>) {
        let faults = RefCell::default();
        let operations = self.checked_operations(&Scope::root(&faults));
        (operations, faults.into_inner())
    }

    fn checked_operations(&self, place: &Scope<'_>) -> Option<Vec<Operation>> {
        let checked = operation_entries!(self).check(place);
        let closed_forms = ClosedForms {
            peak_depth: checked.as_ref().and_then(|checked| checked.peak_depth),
            lambda_a: checked_lambda(&self.lambda_a(), place),
            lambda_b: checked_lambda(&self.lambda_b(), place),
        };
        let methods = self.methods().looked_up(place, |name| closed_forms.method(name));
        let operation = checked?.operation;
        let by_method = |method: Method| {
            let is_taken = takes_two_zones(method, &operation.system.contact, &self.braking(), place);
            is_taken.then_some(Operation { model: ForceModel { method, ..operation.model }, ..operation })
        };
        methods?.into_iter().map(by_method).collect()
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::request::checked;
    use crate::wire::read;

    /// The points that a comparison of eight cases takes, or what is wrong with it.
    fn points(methods: &[&str], slips: usize) -> Result<usize, Vec<FieldFault>> {
        let variants: Vec<_> = (0..7).map(|i| json!({"name": i.to_string(), "normal_stress_radius": "shearing"})).collect();
        let body = json!({
            "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "sinkage_m": 0.02,
            "slip": {"from": 0, "to": 1, "points": slips}, "methods": methods, "variants": variants
        });
        let body = read::<CompareDto>(body.to_string().as_bytes()).expect("JSON");
        checked(&body).map(|query| query.operations().count() * query.slips.len())
    }

    #[test]
    fn operating_points_are_bounded_with_those_of_the_integral() {
        assert_eq!(points(&["explicit"], 6_250), Ok(MOST_POINTS));
        assert_eq!(points(&["explicit", "quadrature"], 6_250), Ok(MOST_POINTS));
        for (methods, slips, found) in
            [(&["explicit"][..], 6_251, "100016"), (&["quadrature", "linearised", "explicit"], 10_001, "240024")]
        {
            let faults = points(methods, slips).expect_err("too many");
            assert_eq!(faults.len(), 1);
            assert_eq!(faults[0].pointer, "/variants");
            assert!(faults[0].detail.contains(found), "{}", faults[0].detail);
        }
    }
}
