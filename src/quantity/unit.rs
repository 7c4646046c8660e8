//! Units as they are written.

use super::number::number;

/// Unit of a sinkage modulus: it depends on the exponent, so UCUM has no code for it.
pub(super) const PRESSURE_PER_POWER: &str = "Pa/m^N";

/// Suffixes of names on the wire, the longer ones first, with the units that they stand for.
const SUFFIXES: [(&str, &str); 18] = [
    ("_rad_s", "rad/s"),
    ("_m_s", "m/s"),
    ("_m_s2", "m/s2"),
    ("_n_m3", "N/m3"),
    ("_n_m", "N.m"),
    ("_j_m", "J/m"),
    ("_pa2", "Pa2"),
    ("_pa", "Pa"),
    ("_rad", "rad"),
    ("_n", "N"),
    ("_m", "m"),
    ("_s", "s"),
    ("_w", "W"),
    ("_j", "J"),
    ("_kg", "kg"),
    ("_coefficient", "1"),
    ("_ratio", "1"),
    ("_over_load", "1"),
];

/// The unit that the suffix of a name stands for, if it has one. Moduli such as k_s are not in seconds.
pub(crate) fn of_name(name: &str) -> Option<&'static str> {
    let has = |suffix: &str| name.len() > suffix.len() + 1 && name.ends_with(suffix);
    SUFFIXES.iter().find(|(suffix, _)| has(suffix)).map(|(_, unit)| *unit)
}

/// Names without a suffix that are ratios.
const RATIOS: [&str; 8] = ["slip", "travel_slip", "c1", "c2", "c3", "n0", "n1", "n2"];

/// The unit that a field of the contract has by its name.
pub(super) fn of_field(name: &str) -> Option<&'static str> {
    of_name(name).or_else(|| RATIOS.contains(&name).then_some("1"))
}

/// A unit in the usual notation: `N·m`, `N/m³`, `–`.
pub(crate) fn shown(unit: &str) -> String {
    let raised = |text: &str, digit: char, small: &str| {
        text.strip_suffix(digit).filter(|rest| rest.ends_with(char::is_alphabetic)).map(|rest| format!("{rest}{small}"))
    };
    if unit == "1" {
        return "–".to_owned();
    }
    let unit = unit.replace('.', "·");
    raised(&unit, '2', "²").or_else(|| raised(&unit, '3', "³")).unwrap_or(unit)
}

/// A value in four digits with its unit; a ratio has none.
pub(crate) fn with_unit(value: f64, unit: &str) -> String {
    match unit {
        "" | "1" => number(value),
        unit => format!("{} {}", number(value), shown(unit)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_shown_as_people_write_them() {
        let written = ["1", "N.m", "N/m3", "m/s2", "Pa2", "N/m^(n+2)", "Pa/m^N", "rad"].map(shown);
        assert_eq!(written, ["–", "N·m", "N/m³", "m/s²", "Pa²", "N/m^(n+2)", "Pa/m^N", "rad"]);
    }

    #[test]
    fn a_suffix_is_a_unit() {
        for (name, unit) in [
            ("torque_n_m", Some("N.m")),
            ("unit_weight_n_m3", Some("N/m3")),
            ("angular_velocity_rad_s", Some("rad/s")),
            ("time_s", Some("s")),
            ("from_s", Some("s")),
            ("k_s", None),
            ("slip", None),
            ("n0", None),
        ] {
            assert_eq!(of_name(name), unit, "{name}");
        }
    }
}
