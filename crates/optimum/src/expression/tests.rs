use super::*;

fn value(formula: &str) -> f64 {
    Expression::new(formula).map_or_else(|fault| panic!("{formula}: {fault}"), |read| read.value(&[3.0, 0.5]))
}

#[test]
fn formulas_are_read_as_an_engineer_writes_them() {
    for (formula, expected) in [
        ("1 + 2 * 3", 7.0),
        ("(1 + 2) * 3", 9.0),
        ("2 - 3 - 4", -5.0),
        ("12 / 3 / 2", 2.0),
        ("-2^2", -4.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("2 * -3", -6.0),
        ("--4", 4.0),
        ("+4", 4.0),
        ("2e-3 * 1E3", 2.0),
        (".5 + 1.", 1.5),
        ("sqrt(16) + abs(-1)", 5.0),
        ("min(4, max(1, 2))", 2.0),
        ("ln(exp(2))", 2.0),
        ("2 * x", 6.0),
        ("x / y + x", 9.0),
    ] {
        assert!((value(formula) - expected).abs() < 1e-14, "{formula}");
    }
    assert!((value("2700*width*2*pi*radius*0.002") - 2700.0 * 3.0 * std::f64::consts::TAU * 0.5 * 0.002).abs() < 1e-12);
    assert!((value("cos(pi) + sin(0) + tan(0) + atan(1)") - (std::f64::consts::FRAC_PI_4 - 1.0)).abs() < 1e-14);
}

#[test]
fn names_are_told_once_in_their_order() {
    let read = Expression::new("b_m * r_m + b_m").expect("a formula");
    assert_eq!(read.names(), ["b_m", "r_m"]);
    assert_eq!(read.value(&[2.0, 5.0]), 12.0);
    assert!(read.value(&[2.0]).is_nan());
}

#[test]
fn what_has_no_value_is_not_hidden() {
    assert!(value("sqrt(-1)").is_nan());
    assert!(value("max(0, sqrt(-1))").is_nan() && value("min(sqrt(-1), 0)").is_nan());
    assert_eq!(value("1 / 0"), f64::INFINITY);
}

#[test]
fn faults_name_what_is_there_and_where() {
    let fault = |formula: &str| Expression::new(formula).expect_err(formula);
    let unexpected = |found: &str, at| ExpressionFault::Unexpected { found: found.to_owned(), at };
    assert_eq!(fault(""), ExpressionFault::EndsEarly);
    assert_eq!(fault("2 *"), ExpressionFault::EndsEarly);
    assert_eq!(fault("(1"), ExpressionFault::EndsEarly);
    assert_eq!(fault("1)"), unexpected(")", 1));
    assert_eq!(fault("2 x"), unexpected("x", 2));
    assert_eq!(fault("2e"), unexpected("e", 1));
    assert_eq!(fault("2 + é"), unexpected("é", 4));
    assert_eq!(fault("é"), unexpected("é", 0));
    assert_eq!(fault("1.2.3"), unexpected("1.2.3", 0));
    assert_eq!(fault("1e999"), unexpected("1e999", 0));
    assert_eq!(fault("x = 1"), unexpected("=", 2));
    assert_eq!(fault("1 * * 2"), unexpected("*", 4));
    assert_eq!(fault("gamma(2)"), ExpressionFault::NoFunction("gamma".to_owned()));
    assert_eq!(fault("min(2)"), ExpressionFault::Arguments { function: "min", takes: 2 });
    assert_eq!(fault("sqrt(2, 3)"), ExpressionFault::Arguments { function: "sqrt", takes: 1 });
    assert_eq!(fault(&"1".repeat(MOST_CHARACTERS + 1)), ExpressionFault::TooLong);
}

#[test]
fn nesting_is_bounded_by_any_way_to_nest() {
    for (open, close) in [("(", ")"), ("-", ""), ("2^", ""), ("sqrt(", ")"), ("min(1,", ")")] {
        let nested = |depth: usize| format!("{}1{}", open.repeat(depth), close.repeat(depth));
        assert!(Expression::new(&nested(MOST_NESTING)).is_ok(), "{open}");
        assert_eq!(Expression::new(&nested(MOST_NESTING + 1)).err(), Some(ExpressionFault::TooDeep), "{open}");
    }
    assert!(Expression::new(&["1"; 250].join("+")).is_ok());
}
