//! `docs/validation.md`: what the errors hang on, how those of others are, and what a fit is worth on data that it has not seen.

use serde_json::{Value, json};

use super::table;
use crate::asking::{get, post, with};

const TEXT: &str = include_str!("../../../docs/validation.md");

/// The sets of the 27 points that others have predicted as well, with nothing fitted.
const SHARED: [&str; 5] =
    ["ding-2011-smooth", "ding-2011-lug10", "hurrell-2025-rashid", "wang-han-2016-smooth", "wang-han-2016-lug10"];

fn sets() -> Vec<Value> {
    get("/v1/validation").ok()["sets"].as_array().expect("sets").clone()
}

/// Tolerance for numbers that the test recomputes by a fit and by solved sinkages of its own: a solved sinkage is good to 1e-9.
const RECOMPUTED: f64 = 1e-9;

fn assert_close(here: f64, there: &Value, place: &str) {
    assert!((here - number(there)).abs() <= RECOMPUTED * here.abs(), "{place}: {here}, the service says {there}");
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

/// Where a known sinkage comes from.
#[derive(Debug, Clone, Copy)]
enum Known {
    Measured,
    FromStandstill,
}

/// The further ways to run the sets: the name of the series, that of the table, the fields and the sinkage of a request.
const VARIANTS: [(&str, &str, &str, Option<Known>); 7] = [
    ("linearised_known_load", "linearised, load and sinkage known", r#"{"method": "linearised"}"#, Some(Known::Measured)),
    (
        "linearised_known_load_from_standstill",
        "linearised, load known, sinkage by (18)",
        r#"{"method": "linearised"}"#,
        Some(Known::FromStandstill),
    ),
    ("quadrature_known_load", "quadrature, load and sinkage known", "{}", Some(Known::Measured)),
    ("quadrature_slip_on_rim", "quadrature, slip on the rim throughout", r#"{"slip_radius": "rim"}"#, None),
    (
        "quadrature_slip_on_shearing_circle",
        "quadrature, slip on the shearing circle throughout",
        r#"{"slip_radius": "shearing"}"#,
        None,
    ),
    ("quadrature_displacement_on_rim", "quadrature, displacement on the rim", r#"{"shear_displacement_radius": "rim"}"#, None),
    ("quadrature_peak_at_half_sinkage", "quadrature, peak at half the sinkage", r#"{"contact": {"rule": "half_sinkage"}}"#, None),
];

/// The error of the pull of a set, asked point by point.
fn varied(id: &str, fields: &Value, sinkage: Option<Known>) -> f64 {
    let set = get(&format!("/v1/validation/{id}")).ok();
    let column = |pointer: &str| -> Vec<f64> {
        set.pointer(pointer).and_then(Value::as_array).expect("a column").iter().map(number).collect()
    };
    let (slips, loads) = (column("/columns/slip"), column("/columns/normal_load_n"));
    let (sinkages, pulls) = (column("/columns/measured/sinkage_m"), column("/columns/measured/drawbar_coefficient"));
    let squares = (0..slips.len()).map(|row| {
        let mut body = json!({
            "wheel": set["wheel"], "soil": set["soil"], "slip_radius": set["slip_radius"],
            "slip": slips[row], "normal_load_n": loads[row]
        });
        match sinkage {
            Some(Known::Measured) => body["sinkage_m"] = sinkages[row].into(),
            // Eq. (18) leads from the first point to the standstill.
            Some(Known::FromStandstill) => {
                body["static_sinkage_m"] = (sinkages[0] * (1.0 - 0.5 * slips[0]) / (1.0 + slips[0])).into();
            }
            None => {}
        }
        let pull = number(&post("/v1/forces", &with(&body, fields.clone())).ok()["longitudinal_force_n"]);
        (pull / loads[row] - pulls[row]).powi(2)
    });
    (squares.sum::<f64>() / slips.len() as f64).sqrt()
}

#[test]
fn the_errors_beside_those_of_others_are_those_of_the_service() {
    /// As the two programs publish them.
    const OTHERS: [(&str, [f64; 5]); 2] =
        [("RoverDevKit", [0.069, 0.064, 0.125, 0.108, 0.117]), ("PINNeAPPle", [0.096, 0.050, 0.122, 0.244, 0.156])];
    let validation = get("/v1/validation").ok();
    let (sets, data) = (validation["sets"].as_array().expect("sets"), &validation["pooled"]);
    let of = |id: &str| sets.iter().find(|set| set["id"] == id).expect("a set");
    let points = SHARED.map(|id| number(&of(id)["points"]));
    assert_eq!(points.iter().sum::<f64>(), 27.0);
    assert_eq!((&data["sets"], &data["points"]), (&json!(SHARED), &json!(27)));
    let results = data["results"].as_array().expect("results");
    let row = |(name, errors, told): (&str, &[f64], (&str, &str))| {
        let of_program = results.iter().find(|result| result[told.0] == told.1).expect("a result");
        assert_eq!(of_program["by_set"], json!(errors), "{name}");
        let over_all = pooled(errors, &points);
        assert_close(over_all, &of_program["drawbar_rmse_over_load"], name);
        let all = errors.iter().copied().chain([over_all]);
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
        .map(|series| row((&format!("this service, {series}"), &ours(series), ("series", series))))
        .collect();
    rows.extend(VARIANTS.iter().map(|(series, named, fields, sinkage)| {
        let fields: Value = serde_json::from_str(fields).expect("JSON");
        let errors = SHARED.map(|id| varied(id, &fields, *sinkage));
        let of_series = results.iter().find(|result| result["series"] == *series).expect("a result");
        for (here, there) in errors.iter().zip(of_series["by_set"].as_array().expect("errors")) {
            assert_close(*here, there, series);
        }
        let over_all = pooled(&errors, &points);
        assert_close(over_all, &of_series["drawbar_rmse_over_load"], series);
        let all = errors.iter().copied().chain([over_all]);
        [format!("this service, {named}")].into_iter().chain(all.map(|error| format!("{error:.3}"))).collect()
    }));
    rows.extend(OTHERS.iter().map(|(name, errors)| row((name, errors, ("program", name)))));
    assert_eq!(results.len(), rows.len());
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

    /// The part as `held_out` names it.
    fn named(&self) -> Value {
        json!({"set": self.set["id"], "rows": self.rows})
    }

    /// The soil with these parameters fitted to the pull of the part, under its loads; nothing fitted, the published one.
    fn fitted(&self, parameters: &[&str]) -> Value {
        if parameters.is_empty() {
            return self.set["soil"].clone();
        }
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
/// soil. What `held_out` has is computed here through `/v1/identify` and `/v1/forces`, and the table is both.
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
    const FITS: [&[&str]; 3] = [&[], &["shear_modulus_m"], &["friction_angle_rad", "shear_modulus_m"]];
    let data = get("/v1/validation").ok()["held_out"].as_array().expect("splits").clone();
    assert_eq!(data.len(), cases.len());
    let mut helped = 0;
    let rows: Vec<Vec<String>> = cases
        .iter()
        .zip(&data)
        .map(|((fitted_on, fitted, scored_on, scored), told)| {
            assert_eq!((&told["fitted_on"], &told["scored_on"]), (&fitted.named(), &scored.named()));
            assert_eq!(told["results"].as_array().map(Vec::len), Some(FITS.len()));
            let [(nothing, _), (modulus, _), (unseen, own)] = [0, 1, 2].map(|i| {
                let (told, parameters) = (&told["results"][i], FITS[i]);
                let soil = fitted.fitted(parameters);
                assert_eq!(
                    (&told["fitted"], told["values"].as_object().map(|of| of.len())),
                    (&json!(parameters), Some(parameters.len()))
                );
                for name in parameters {
                    assert_close(number(&soil[name]), &told["values"][name], name);
                }
                let (unseen, own) = (scored.error(&soil), fitted.error(&soil));
                assert_close(unseen, &told["drawbar_rmse_over_load"], scored_on);
                assert_close(own, &told["on_fitted_part"], fitted_on);
                (unseen, own)
            });
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
