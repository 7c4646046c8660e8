//! Fields that are looked up by their paths.

use terramechanics_reading::{Alternative, Field, Flag, Hints, Label, Number, Numbers, Object, Objects, OneOf, Path};

const METRES: Number = Number::new("m", 0.0, 1.0);
const RADIUS: Field<Number> = Field::new("radius_m", "Radius.", METRES);
const WHEEL: Object = Object { name: "Wheel", doc: "A wheel.", groups: &[&[&RADIUS]] };
const WHEEL_FIELD: Field<&Object> = Field::new("wheel", "The wheel.", &WHEEL);
const STATIONS: Field<Objects> = Field::new("stations", "Wheels.", Objects { object: &WHEEL, fewest: 0, most: 3 });
const NAME: Field<Label> = Field::new("name", "A name.", Label);
const RUT: Field<Flag> = Field::new("rut", "Whether.", Flag);
const SLOPES: Field<OneOf> = Field::new(
    "slope_rad",
    "Slopes.",
    OneOf::new("a number or an array", &[Alternative::Number(METRES), Alternative::Numbers(Numbers::new(METRES, 1, 2))]),
);
const ROVER: Object = Object { name: "Rover", doc: "A rover.", groups: &[&[&WHEEL_FIELD, &STATIONS, &NAME, &RUT, &SLOPES]] };

/// The declaration that a pointer leads to, in words: it may have a function, and these cannot be compared.
fn found(pointer: &str) -> Result<String, String> {
    let path = Path::of_pointer(pointer).expect("a pointer");
    ROVER.number_at(&path, &Hints::NONE).map(|number| format!("{number:?}")).map_err(|astray| astray.to_string())
}

#[test]
fn a_path_leads_to_a_number() {
    for pointer in ["/wheel/radius_m", "/stations/2/radius_m", "/slope_rad"] {
        assert_eq!(found(pointer), Ok(format!("{METRES:?}")), "{pointer}");
    }
    let path = Path::of_dotted("wheel.radius_m").expect("a path");
    assert_eq!((path.pointer().as_str(), path.dotted().as_str()), ("/wheel/radius_m", "wheel.radius_m"));
    let odd = Path::of_pointer("/a~1b/~01").expect("a pointer");
    assert_eq!((odd.names(), odd.pointer().as_str()), (&["a/b".to_owned(), "~1".to_owned()][..], "/a~1b/~01"));
    assert_eq!((Path::of_pointer("wheel"), Path::of_pointer(&"/a".repeat(1_000_000))), (None, None));
}

#[test]
fn what_is_no_number_is_told() {
    for (pointer, said) in [
        ("/wheel/raduis_m", "the request has no field `/wheel/raduis_m`; did you mean `/wheel/radius_m`?"),
        ("/radius_m", "the request has no field `/radius_m`; did you mean `/wheel/radius_m`?"),
        ("/wheel", "must name a number, not an object; its fields are radius_m"),
        ("/wheel/radius_m/x", "`/wheel/radius_m` is a number, which has no fields"),
        ("/stations/first/radius_m", "the request has no field `/stations/first`; a list has items, which are counted from 0"),
        ("/stations", "must name a number, not a list of objects"),
        ("/name", "must name a number, not a word"),
        ("/rut/0", "`/rut` is true or false, which has no fields"),
    ] {
        assert_eq!(found(pointer), Err(said.to_owned()), "{pointer}");
    }
}
