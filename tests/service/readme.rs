//! What the README shows is what the service answers.

use serde_json::Value;

use crate::asking::{get, post, post_for_csv};

const README: &str = include_str!("../../README.md");

/// The contents of the README's code blocks in a language.
fn blocks(language: &str) -> Vec<&'static str> {
    let opening = format!("```{language}\n");
    README.split(opening.as_str()).skip(1).map(|rest| rest.split("```").next().expect("a block ends")).collect()
}

/// The body and the path of a curl command.
fn command(block: &str) -> (String, Value) {
    let path = block.split("127.0.0.1:8080").nth(1).and_then(|rest| rest.split(' ').next()).expect("a path");
    let body = block.split("-d '").nth(1).and_then(|rest| rest.split('\'').next()).expect("a body");
    (path.to_owned(), serde_json::from_str(body).expect("JSON"))
}

#[test]
fn the_first_request_has_the_answer_shown() {
    let (path, body) = command(blocks("sh")[0]);
    let shown: Value = serde_json::from_str(blocks("json")[0]).expect("JSON");
    let answer = post(&path, &body).ok();
    let close = |a: &Value, b: &Value| (a.as_f64().expect("a number") - b.as_f64().expect("a number")).abs() < 1e-9;
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "drawbar_coefficient", "tractive_efficiency"] {
        assert!(close(&shown[name], &answer[name]), "{name}");
    }
    assert_eq!(shown["warnings"], answer["warnings"]);
    let names = |value: &Value| value.as_object().expect("an object").keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&shown), names(&answer));
}

#[test]
fn the_explicit_figures_are_those_quoted() {
    let (path, mut body) = command(blocks("sh")[0]);
    body["method"] = "explicit".into();
    let answer = post(&path, &body).ok();
    let rounded = |name: &str, digits: usize| format!("{:.digits$}", answer[name].as_f64().expect("a number"));
    let quoted = [rounded("longitudinal_force_n", 1), rounded("normal_force_n", 1), rounded("torque_n_m", 2)];
    assert_eq!(quoted, ["12.1", "55.8", "4.72"]);
    assert!(README.contains("12.1 N, 55.8 N and 4.72 N·m"));
}

#[test]
fn the_sweep_is_a_table_of_101_rows() {
    let (path, body) = command(blocks("sh")[1]);
    assert_eq!(post_for_csv(&path, &body).text.lines().count(), 102);
}

#[test]
fn the_problem_shown_is_what_is_said() {
    let shown: Value = serde_json::from_str(blocks("json")[1]).expect("JSON");
    let (path, mut body) = command(blocks("sh")[0]);
    body["wheel"]["radus_m"] = 1.into();
    assert_eq!(post(&path, &body).problem(422)["errors"][0], shown);
}

#[test]
fn the_classical_estimates_are_those_quoted() {
    let example = serde_json::json!({
        "wheel": {"radius_m": 0.4065, "width_m": 0.229}, "normal_load_n": 259,
        "soil": {"preset": "lunar-apollo-nominal", "friction_angle_rad": 0.576, "unit_weight_n_m3": 2472}
    });
    let answer = post("/v1/resistances", &example).ok();
    let rounded = |name: &str, digits: usize| format!("{:.digits$}", answer[name].as_f64().expect("a number"));
    assert_eq!([rounded("compaction_resistance_n", 2), rounded("bulldozing_resistance_n", 1)], ["28.34", "90.4"]);
    assert!(README.contains("28.34 N of compaction and 90.4 N of bulldozing"));
}

/// Each with the block of the README that shows its request, by language and place among the blocks of that language.
const CLIENTS: [(&str, &str, usize); 6] = [
    (include_str!("../../clients/curve_pandas.py"), "python", 0),
    (include_str!("../../clients/forces_requests.py"), "python", 1),
    (include_str!("../../clients/generated_client.py"), "python", 2),
    (include_str!("../../clients/curve.m"), "matlab", 0),
    (include_str!("../../clients/forces.mjs"), "js", 0),
    (include_str!("../../clients/curve.sh"), "sh", 2),
];

#[test]
fn what_is_shown_of_a_client_stands_in_its_program() {
    for (program, language, place) in CLIENTS {
        let block = blocks(language)[place];
        assert!(!block.is_empty() && program.contains(&format!("\n{block}")), "no program has: {block}");
    }
    for language in ["python", "matlab", "js"] {
        let shown = CLIENTS.iter().filter(|client| client.1 == language).count();
        assert_eq!(blocks(language).len(), shown, "{language}");
    }
}

#[test]
fn the_commands_that_generate_a_client_are_those_of_its_program() {
    for (program, command) in [
        (CLIENTS[2].0, "openapi-python-client generate --meta none --url http://127.0.0.1:8080/openapi.json"),
        (
            CLIENTS[4].0,
            "openapi-typescript http://127.0.0.1:8080/openapi.json --default-non-nullable=false --output terramechanics.d.ts",
        ),
    ] {
        assert!(README.contains(&format!("`{command}`")) && program.contains(command), "{command}");
    }
}

#[test]
fn both_commands_are_named() {
    assert!(README.contains("cargo run --release") && README.contains("cargo test --workspace"));
}

#[test]
fn the_size_of_the_catalogue_is_the_one_stated() {
    let size = |path: &str, name: &str| get(path).ok()[name].as_array().expect("a list").len();
    let stated = format!("{} wheels and {} soils", size("/v1/wheels", "wheels"), size("/v1/soils", "soils"));
    assert!(README.contains(&stated), "{stated}");
}

fn sets() -> Vec<Value> {
    get("/v1/validation").ok()["sets"].as_array().expect("sets").clone()
}

fn rounded(value: &Value, factor: f64, digits: usize) -> String {
    value.as_f64().map_or_else(|| "–".to_owned(), |value| format!("{:.digits$}", value * factor))
}

/// An error over the load; in brackets the points with a solution, where some have none.
fn over_load(result: &Value, error: &str) -> String {
    let error = rounded(&result[error], 1.0, 3);
    if result["unsolved"] == 0 { error } else { format!("{error} ({})", result["solved"]) }
}

fn assert_row(cells: &[String]) {
    let row = format!("| {} |", cells.join(" | "));
    assert!(README.lines().any(|line| line == row), "the README lacks: {row}");
}

/// Every set with its errors, rounded as shown.
#[test]
fn the_errors_against_measurements_are_those_of_the_service() {
    let sets = sets();
    for set in &sets {
        let results = set["results"].as_array().expect("results");
        let kind = if results[0]["fitted"] == true { "fitted" } else { "predicted" };
        let mut cells = vec![format!("`{}`", set["id"].as_str().expect("an id")), set["points"].to_string(), kind.to_owned()];
        if set["slip_angle_rad"].is_number() {
            cells.extend(results.iter().map(|result| over_load(result, "lateral_rmse_over_load")));
            cells.extend([0, 2].map(|i| over_load(&results[i], "drawbar_rmse_over_load")));
        } else {
            cells.extend(results.iter().take(3).map(|result| over_load(result, "drawbar_rmse_over_load")));
            cells.push(rounded(&results[0]["sinkage_rmse_m"], 1e3, 1));
            cells.push(rounded(&results[0]["torque_rmse_n_m"], 1.0, 2));
        }
        assert_row(&cells);
    }
    assert_eq!(README.lines().filter(|line| line.contains("| predicted |") || line.contains("| fitted |")).count(), sets.len());
}

/// Both laws of braking, each error as shown, and over the rows that both solve, recomputed here.
#[test]
fn the_errors_of_both_laws_of_braking_are_those_of_the_service() {
    let mut braking = 0;
    for set in sets() {
        let results = set["results"].as_array().expect("results");
        let Some(two) = results.iter().find(|result| result["braking"] == "two_zone") else { continue };
        let mut cells = vec![format!("`{}`", set["id"].as_str().expect("an id"))];
        cells.extend([&results[0], two].map(|result| over_load(result, "drawbar_rmse_over_load")));
        cells.extend([&results[0], two].map(|result| rounded(&result["sinkage_rmse_m"], 1e3, 1)));
        assert_row(&cells);
        braking += 1;
        if set["id"] == "cmu-grousered-braking" {
            let errors = common_errors(std::slice::from_ref(&set), &["quadrature", "quadrature_two_zone"], "drawbar_coefficient");
            assert_eq!(errors.map(|(error, points)| (format!("{error:.3}"), points)), Some(("0.049".to_owned(), 3)));
        }
    }
    assert_eq!(braking, 2);
    assert!(README.contains("one zone errs by 0.049, too"));
}

/// The error of the first series over the points that all of them solve, and their number.
fn common_errors(sets: &[Value], series: &[&str], name: &str) -> Option<(f64, usize)> {
    let mut squares = Vec::new();
    for set in sets {
        let columns = &set["columns"];
        for row in 0..columns["slip"].as_array()?.len() {
            let all: Option<Vec<f64>> = series.iter().map(|series| columns["predicted"][series][name][row].as_f64()).collect();
            squares.extend(all.map(|all| (all[0] - columns["measured"][name][row].as_f64().unwrap_or(f64::NAN)).powi(2)));
        }
    }
    let count = squares.len();
    (count > 0).then(|| ((squares.iter().sum::<f64>() / count as f64).sqrt(), count))
}

/// The errors of the lateral force over all slip angles, from the columns.
#[test]
fn the_pooled_errors_of_the_side_force_are_those_of_the_columns() {
    const SERIES: [&str; 4] = ["quadrature", "quadrature_mobilised", "quadrature_coupled", "quadrature_coupled_mobilised"];
    let of = |wheel: &str| -> Vec<Value> {
        let prefix = format!("cmu-{wheel}-side-");
        sets().into_iter().filter(|set| set["id"].as_str().is_some_and(|id| id.starts_with(&prefix))).collect()
    };
    let text = README.replace('\n', " ");
    let pooled = |sets: &[Value], beside: &[&str]| {
        let errors = SERIES.map(|series| {
            let together: Vec<&str> = [series].into_iter().chain(beside.iter().copied()).collect();
            common_errors(sets, &together, "lateral_coefficient").expect("points")
        });
        let words = errors.map(|(error, _)| format!("{error:.3}"));
        (format!("{}, {}, {} and {}", words[0], words[1], words[2], words[3]), errors.map(|(_, count)| count))
    };
    let (grousered, smooth) = (of("grousered"), of("smooth"));
    for (sets, beside, counts) in [(&grousered, &[][..], [24; 4]), (&smooth, &[], [24, 24, 22, 22]), (&smooth, &SERIES, [22; 4])]
    {
        let (words, found) = pooled(sets, beside);
        assert!(text.contains(&words), "the README lacks: {words}");
        assert_eq!(found, counts);
    }
    assert!(README.contains("0.35 and 0.27 of the load"));
    for (sets, driving, braking) in [(&grousered, "0.07", "0.27"), (&smooth, "0.04", "0.19")] {
        for (series, drives, quoted) in [(SERIES[1], true, driving), (SERIES[3], true, driving), (SERIES[3], false, braking)] {
            let parts: Vec<Value> = sets.iter().map(|set| only(set, |slip| (slip >= 0.0) == drives)).collect();
            let (error, _) = common_errors(&parts, &[series], "lateral_coefficient").expect("points");
            assert_eq!(format!("{error:.2}"), quoted, "{series}");
        }
    }
    assert!(text.contains("down to 0.07 (grousered) and 0.04 (smooth)") && text.contains("the last pair least: 0.27 and 0.19"));
}

/// The set with its predictions at other slips struck out.
fn only(set: &Value, is_meant: impl Fn(f64) -> bool) -> Value {
    let mut set = set.clone();
    let slips: Vec<f64> = set["columns"]["slip"].as_array().expect("slips").iter().filter_map(Value::as_f64).collect();
    for forces in set["columns"]["predicted"].as_object_mut().expect("series").values_mut() {
        for (row, _) in slips.iter().enumerate().filter(|(_, slip)| !is_meant(**slip)) {
            forces["lateral_coefficient"][row] = Value::Null;
        }
    }
    set
}
