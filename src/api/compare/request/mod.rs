//! The request of `/v1/compare`.

mod variant;

use terramechanics::{ForceModel, Method, Operation, Slip};
use terramechanics_reading::{Faults, Field, FieldFault, Figures, Object, Reader, Scope, Words};

use crate::request::axis::{self, SLIP_OR_SLIPS};
use crate::request::circles::CIRCLES;
use crate::request::method::{
    BRAKING, ClosedForms, LAMBDAS, LETTER_METHODS, METHODS, MethodName, STRESSES, needs_of_all, takes_two_zones,
};
use crate::request::sinkage::is_under_load;
use crate::request::sinkage::{self, SINKAGE};
use crate::request::system::{self, SYSTEM};
use crate::request::unused::{Reads, Unused};
use crate::request::{Documented, Request, operation};
use variant::VARIANTS;

const METHODS_FIELD: Field<Words<MethodName>> = Field::new(
    "methods",
    "The methods to compare, all different; the other series are compared with that of the first. Those of the letter unless given: `resistive_force` asks other values of the soil.",
    Words { word: METHODS, most: METHODS.words.len(), first_unless_given: LETTER_METHODS },
);

/// Operating points of all series, with those of the quadrature where it is not among the methods.
const MOST_POINTS: usize = 100_000;

/// A comparison, checked.
pub(crate) struct CompareCase {
    /// The request as it stands, then each of its variants.
    pub(crate) variations: Vec<Variation>,
    pub(crate) slips: Vec<Slip>,
    /// What was sent and none of the methods reads.
    pub(crate) unused: Unused,
}

/// The operations by method, of which there is at least one, that differ in nothing else.
pub(crate) struct Variation {
    /// The name of the variant; none of the request as it stands.
    pub(crate) variant: Option<String>,
    pub(crate) operations: Vec<Operation>,
}

impl Variation {
    /// The quadrature of the variation, where it is not among the operations and the soil has the laws that it needs.
    pub(crate) fn quadrature_beside(&self) -> Option<Operation> {
        let is_there = self.operations.iter().any(|operation| operation.model.method == Method::Quadrature);
        let first = self.operations.first().filter(|_| !is_there)?;
        let soil = first.system.soil;
        soil.shear().and(soil.sinkage_exponent().map(|_| ()))?;
        Some(Operation { model: ForceModel { method: Method::Quadrature, ..first.model }, ..*first })
    }
}

impl CompareCase {
    /// All operations that an answer takes.
    pub(crate) fn operations(&self) -> impl Iterator<Item = Operation> {
        let all = |variation: &Variation| variation.operations.clone().into_iter().chain(variation.quadrature_beside());
        self.variations.iter().flat_map(all)
    }
}

pub(super) type CompareRequest = Documented<CompareCase>;

impl Request for CompareCase {
    const OBJECT: &'static Object = &Object {
        name: "CompareRequest",
        doc: "The forces at one slip, or over a range or a list of slips, by several methods and laws at once. The fields are those of a slip sweep straight ahead, with `methods` for `method`; `slip` may be one number. Every method is applied to the request as it stands and to each of its `variants`; with all their series, and the quadrature where it is not among the methods, there may be 100000 operating points.",
        groups: &[SYSTEM, CIRCLES, &[&SLIP_OR_SLIPS], SINKAGE, &[&METHODS_FIELD], STRESSES, BRAKING, LAMBDAS, &[&VARIANTS]],
    };

    fn read(object: &Reader<'_>) -> Option<Self> {
        let (own, faults) = own_operations(object);
        let (own, mut unused) = own.unzip();
        faults.iter().for_each(|fault| object.place().pass_on(fault.clone()));
        let slips = axis::read(object, &SLIP_OR_SLIPS);
        let mut names: Vec<String> = Vec::new();
        let variants = object.optional(&VARIANTS).and_then(|variants| {
            variants.unwrap_or_default().each(|variant, index| {
                let name = variant::name(variant, &names);
                names.extend(name.clone());
                let operations = variant::operations(object, (variant, index), &faults);
                let (operations, of_variant) = operations?;
                unused.get_or_insert_default().extend(of_variant);
                Some(Variation { variant: Some(name?), operations })
            })
        });
        let mut variations = vec![Variation { variant: None, operations: own? }];
        variations.extend(variants?);
        let case = Self { variations, slips: slips?, unused: unused.unwrap_or_default() };
        let points = case.operations().count() * case.slips.len();
        if points > MOST_POINTS {
            let figures = Figures { value: Some(points as f64), maximum: Some(MOST_POINTS as f64), ..Figures::default() };
            let detail = format_args!(
                "all series, with the quadrature, have {points} operating points in all; {MOST_POINTS} is the most that is computed"
            );
            object.place_of(&VARIANTS).report(figures, detail);
            return None;
        }
        Some(case)
    }
}

/// The operations of the request as it stands, and what is wrong with them.
fn own_operations(object: &Reader<'_>) -> (Option<(Vec<Operation>, Unused)>, Vec<FieldFault>) {
    let faults = Faults::apart(object.place());
    let operations = operations(&object.at(Scope::root(&faults)), None);
    object.place().assume_all(faults.assumptions().unwrap_or_default());
    (operations, faults.into_list())
}

/// The operations by every method, with the laws that `variant` has in place of the soil's own, and what none of them reads.
fn operations(object: &Reader<'_>, variant: Option<&Reader<'_>>) -> Option<(Vec<Operation>, Unused)> {
    let needs = operation::beside_load(object, needs_of_all(object, &METHODS_FIELD));
    let system = system::read_varied(object, variant, needs);
    let found = operation::read_with(object, system, sinkage::read, |_, _| Some(Method::Quadrature));
    let closed_forms = ClosedForms::read(object, found.peak_depth);
    let methods = object.or_default(&METHODS_FIELD);
    let (operation, soil) = (found.operation?, found.soil?);
    let by_method = |name: MethodName| {
        let method = closed_forms.method(name);
        let has_law = operation::has_its_law(object, &method, &soil);
        let is_taken = has_law && takes_two_zones(object, method, &operation.system.contact);
        is_taken.then_some(Operation { model: ForceModel { method, ..operation.model }, ..operation })
    };
    let operations: Vec<Operation> = methods?.into_iter().map(by_method).collect::<Option<_>>()?;
    // The gap to the quadrature is told wherever the soil has its laws.
    let beside = soil.soil.shear().and(soil.soil.pressure_sinkage()).map(|_| Reads::STRESSES);
    let by = |operation: &Operation| Reads::by(&operation.model.method, is_under_load(object));
    let reads = operations.iter().map(by).chain(beside).reduce(Reads::and)?;
    Some((operations, Unused::of(object, reads, &operation.system)))
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use terramechanics_reading::Node;

    use super::*;
    use crate::request::checked;

    /// The points that a comparison of eight cases takes, or what is wrong with it.
    fn points(methods: &[&str], slips: usize) -> Result<usize, Vec<FieldFault>> {
        let variants: Vec<_> = (0..7).map(|i| json!({"name": i.to_string(), "normal_stress_radius": "shearing"})).collect();
        let body = json!({
            "wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "sinkage_m": 0.02,
            "slip": {"from": 0, "to": 1, "points": slips}, "methods": methods, "variants": variants
        });
        checked::<CompareCase>(&Node::from(&body)).map(|case| case.operations().count() * case.slips.len())
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
