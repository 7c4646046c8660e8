//! `docs/validation.md`: what the errors hang on, how those of others are, and what a fit is worth on data that it has not seen.

use serde_json::{Value, json};

use super::table;
use crate::asking::{get, post};

const TEXT: &str = include_str!("../../../docs/validation.md");

/// The sets of the 27 points that others have predicted as well, with nothing fitted.
const SHARED: [&str; 5] =
    ["ding-2011-smooth", "ding-2011-lug10", "hurrell-2025-rashid", "wang-han-2016-smooth", "wang-han-2016-lug10"];

fn sets() -> Vec<Value> {
    get("/v1/validation").ok()["sets"].as_array().expect("sets").clone()
}

fn text(value: &Value) -> &str {
    value.as_str().expect("a text")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

fn assert_table(heading: &str, rows: &[Vec<String>]) {
    let markdown: Vec<String> = rows.iter().map(|cells| format!("| {} |", cells.join(" | "))).collect();
    assert_eq!(table(TEXT, heading), rows, "{heading} has to read\n{}", markdown.join("\n"));
}

/// How the shear modulus of every set with nothing fitted is known, and the errors at half, one and two times it.
#[test]
fn the_sensitivities_are_those_of_the_service() {
    let unfitted = sets().into_iter().filter(|set| set["sensitivity"].is_array() && set["fitted_to"].is_null());
    let row = |set: Value| {
        let modulus = set["inputs"].as_array().expect("inputs").iter().find(|of| of["name"] == "soil.shear_modulus_m");
        let errors: Vec<&Value> = set["sensitivity"].as_array().expect("rows").iter().collect();
        let mut cells = vec![format!("`{}`", text(&set["id"])), format!("{:.1}", 1e3 * number(&errors[1]["shear_modulus_m"]))];
        cells.push(text(&modulus.expect("a modulus")["origin"]).to_owned());
        cells.extend(errors.iter().map(|at| format!("{:.3}", number(&at["drawbar_rmse_over_load"]))));
        cells
    };
    assert_table("## What hangs on the shear modulus", &unfitted.map(row).collect::<Vec<_>>());
}

/// The error over the points of several sets together.
fn pooled(errors: &[f64], points: &[f64]) -> f64 {
    let squares: f64 = errors.iter().zip(points).map(|(error, points)| error * error * points).sum();
    (squares / points.iter().sum::<f64>()).sqrt()
}

#[test]
fn the_errors_beside_those_of_others_are_those_of_the_service() {
    /// As the two programs publish them.
    const OTHERS: [(&str, [f64; 5]); 2] =
        [("RoverDevKit", [0.069, 0.064, 0.125, 0.108, 0.117]), ("PINNeAPPle", [0.096, 0.050, 0.122, 0.244, 0.156])];
    let sets = sets();
    let of = |id: &str| sets.iter().find(|set| set["id"] == id).expect("a set");
    let points = SHARED.map(|id| number(&of(id)["points"]));
    assert_eq!(points.iter().sum::<f64>(), 27.0);
    let row = |name: &str, errors: &[f64]| {
        let all = errors.iter().copied().chain([pooled(errors, &points)]);
        [name.to_owned()].into_iter().chain(all.map(|error| format!("{error:.3}"))).collect::<Vec<_>>()
    };
    let ours = |series: &str| {
        SHARED.map(|id| {
            let mut results = of(id)["results"].as_array().expect("results").iter();
            let result = results.find(|result| result["series"] == series).expect("a result");
            assert_eq!((&result["unsolved"], &result["fitted"]), (&json!(0), &json!(false)), "{id}");
            number(&result["drawbar_rmse_over_load"])
        })
    };
    let mut rows: Vec<Vec<String>> = ["quadrature", "linearised", "explicit", "resistive_force"]
        .iter()
        .map(|series| row(&format!("this service, {series}"), &ours(series)))
        .collect();
    rows.extend(OTHERS.iter().map(|(name, errors)| row(name, errors)));
    assert_table("## Beside other programs", &rows);
}

/// Points of a set: its rows with these indices.
struct Part {
    set: Value,
    rows: Vec<usize>,
    contact: Value,
}

impl Part {
    fn of(id: &str, is_meant: impl Fn(usize) -> bool) -> Self {
        let set = get(&format!("/v1/validation/{id}")).ok();
        let rows = (0..set["points"].as_u64().expect("points") as usize).filter(|row| is_meant(*row)).collect();
        Self { set, rows, contact: json!({"rule": "midpoint"}) }
    }

    fn column(&self, pointer: &str) -> Vec<f64> {
        let column = self.set.pointer(pointer).expect("a column");
        self.rows.iter().map(|row| number(&column[*row])).collect()
    }

    fn request(&self, soil: &Value) -> Value {
        let mut body = json!({"wheel": self.set["wheel"], "soil": soil, "contact": self.contact});
        if self.set["slip_radius"].is_string() {
            body["slip_radius"] = self.set["slip_radius"].clone();
        }
        body
    }

    /// The soil with these parameters fitted to the pull of the part, under its loads.
    fn fitted(&self, parameters: &[&str]) -> Value {
        let mut body = self.request(&self.set["soil"]);
        body["fit"] = json!(parameters);
        body["data"] = json!({
            "slip": self.column("/columns/slip"),
            "normal_force_n": self.column("/columns/normal_load_n"),
            "longitudinal_force_n": self.column("/columns/measured/longitudinal_force_n"),
        });
        let found = post("/v1/identify", &body).ok();
        assert_eq!(found["converged"], true);
        found["soil"].clone()
    }

    /// The error of the pull over the load with that soil.
    fn error(&self, soil: &Value) -> f64 {
        let [slips, loads, pulls] =
            ["/columns/slip", "/columns/normal_load_n", "/columns/measured/longitudinal_force_n"].map(|name| self.column(name));
        let squares = (0..slips.len()).map(|row| {
            let mut body = self.request(soil);
            body["slip"] = json!(slips[row]);
            body["normal_load_n"] = json!(loads[row]);
            let found = number(&post("/v1/forces", &body).ok()["longitudinal_force_n"]);
            ((found - pulls[row]) / loads[row]).powi(2)
        });
        (squares.sum::<f64>() / slips.len() as f64).sqrt()
    }
}

/// The same 27 points with published coefficients of the angle of maximum stress.
#[test]
fn the_errors_of_the_rules_of_contact_are_those_of_the_service() {
    let wong_reece = |c1: f64, c2: f64| json!({"rule": "wong_reece", "c1": c1, "c2": c2});
    let rules = [
        ("midway, the default", json!({"rule": "midpoint"})),
        ("c1 = 0.43, c2 = 0.32: compact sand", wong_reece(0.43, 0.32)),
        ("c1 = 0.18, c2 = 0.32: loose sand", wong_reece(0.18, 0.32)),
        ("c1 = 0.4, c2 = 0.2: as RoverDevKit", wong_reece(0.4, 0.2)),
    ];
    let row = |(name, contact): &(&str, Value)| {
        let parts = SHARED.map(|id| Part { contact: contact.clone(), ..Part::of(id, |_| true) });
        let points = parts.each_ref().map(|part| part.rows.len() as f64);
        let errors = parts.map(|part| part.error(&part.set["soil"]));
        let all = errors.iter().copied().chain([pooled(&errors, &points)]);
        [(*name).to_owned()].into_iter().chain(all.map(|error| format!("{error:.3}"))).collect::<Vec<_>>()
    };
    assert_table("## What hangs on the angle of maximum stress", &rules.iter().map(row).collect::<Vec<_>>());
}

/// Fitted on one part of Ding's tests, scored on the other: half of the slips of a wheel, or all of the other wheel on the same
/// soil.
#[test]
fn what_was_fitted_on_one_part_is_scored_on_the_other() {
    let half = |wheel: &str, parity: usize| Part::of(&format!("ding-2011-{wheel}"), move |row| row % 2 == parity);
    let whole = |wheel: &str| Part::of(&format!("ding-2011-{wheel}"), |_| true);
    let cases = [
        ("smooth, slips 0, 0.2, 0.4", half("smooth", 0), "smooth, slips 0.1, 0.3, 0.6", half("smooth", 1)),
        ("smooth, slips 0.1, 0.3, 0.6", half("smooth", 1), "smooth, slips 0, 0.2, 0.4", half("smooth", 0)),
        ("lugs, slips 0, 0.2, 0.4", half("lug10", 0), "lugs, slips 0.1, 0.3, 0.6", half("lug10", 1)),
        ("lugs, slips 0.1, 0.3, 0.6", half("lug10", 1), "lugs, slips 0, 0.2, 0.4", half("lug10", 0)),
        ("smooth", whole("smooth"), "lugs", whole("lug10")),
        ("lugs", whole("lug10"), "smooth", whole("smooth")),
    ];
    let mut helped = 0;
    let rows: Vec<Vec<String>> = cases
        .iter()
        .map(|(fitted_on, fitted, scored_on, scored)| {
            let nothing = scored.error(&scored.set["soil"]);
            let modulus = scored.error(&fitted.fitted(&["shear_modulus_m"]));
            let both = fitted.fitted(&["friction_angle_rad", "shear_modulus_m"]);
            let (unseen, own) = (scored.error(&both), fitted.error(&both));
            assert!(own < unseen, "{scored_on}: {unseen}, {own}");
            helped += usize::from(unseen < nothing);
            let errors = [nothing, modulus, unseen, own].map(|error| format!("{error:.3}"));
            [*fitted_on, *scored_on].map(str::to_owned).into_iter().chain(errors).collect()
        })
        .collect();
    assert_table("## Held out", &rows);
    let said = format!("Fitting φ and K helps on unseen points in {helped} of the {} rows.", rows.len());
    assert!(TEXT.contains(&said), "{said}");
}
