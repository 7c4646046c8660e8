//! Every unknown, from the tables of the model.

use terramechanics::{Fittable, Interface, Lambda, Law, PeakRule, PressureSinkage, ShearLaw, Soil, WheelOnSoil};

/// What of a setup has the unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Home {
    /// The soil itself.
    Soil,
    /// Its shear law.
    Shear,
    /// Its pressure–sinkage law.
    PressureSinkage,
    /// The rule of the contact.
    Rule,
    /// The interface between rim and soil.
    Interface,
    /// The method.
    Method,
    /// The source of the sinkage.
    Sinkage,
}

/// An unknown, as it is declared, and what has it.
#[derive(Clone, Copy)]
pub(super) struct Row {
    pub(super) fittable: &'static Fittable,
    pub(super) home: Home,
}

/// Rows of all the tables, those that laws share as often as they are there.
const MOST: usize = 200;

#[derive(Clone, Copy)]
struct Rows {
    rows: [Option<Row>; MOST],
    count: usize,
}

impl Rows {
    const fn and(mut self, fittable: &'static [Fittable], home: Home) -> Self {
        let mut i = 0;
        while i < fittable.len() {
            self.rows[self.count] = Some(Row { fittable: &fittable[i], home });
            self.count += 1;
            i += 1;
        }
        self
    }

    const fn and_of<F>(mut self, laws: &'static [Law<F>], home: Home) -> Self {
        let mut i = 0;
        while i < laws.len() {
            self = self.and(laws[i].fittable, home);
            i += 1;
        }
        self
    }

    /// Whether another row of that name follows: what laws share comes behind what each has of its own.
    const fn is_repeated(&self, at: usize) -> bool {
        let mut i = at + 1;
        while i < self.count {
            if let (Some(one), Some(other)) = (&self.rows[at], &self.rows[i])
                && is_same(one.fittable.parameter.name, other.fittable.parameter.name)
            {
                return true;
            }
            i += 1;
        }
        false
    }

    /// The first row with the name of the one at `at`.
    const fn first_like(&self, at: usize) -> Option<Row> {
        let mut i = 0;
        while i < at {
            if let (Some(one), Some(other)) = (&self.rows[i], &self.rows[at])
                && is_same(one.fittable.parameter.name, other.fittable.parameter.name)
            {
                return Some(*one);
            }
            i += 1;
        }
        self.rows[at]
    }

    const fn distinct(&self) -> usize {
        let (mut i, mut distinct) = (0, 0);
        while i < self.count {
            distinct += !self.is_repeated(i) as usize;
            i += 1;
        }
        distinct
    }
}

const LISTED: Rows = Rows { rows: [None; MOST], count: 0 }
    .and(Soil::FITTABLE, Home::Soil)
    .and_of(ShearLaw::LAWS, Home::Shear)
    .and_of(PressureSinkage::LAWS, Home::PressureSinkage)
    .and_of(PeakRule::LAWS, Home::Rule)
    .and(Interface::FITTABLE, Home::Interface)
    .and(Lambda::FITTABLE, Home::Method)
    .and(WheelOnSoil::FITTABLE, Home::Sinkage);

pub(super) const COUNT: usize = LISTED.distinct();

/// Each unknown once.
pub(super) static ROWS: [Row; COUNT] = TABLE;

pub(super) const TABLE: [Row; COUNT] = {
    let mut rows = [Row { fittable: &Soil::FITTABLE[0], home: Home::Soil }; COUNT];
    let (mut i, mut place) = (0, 0);
    while i < LISTED.count {
        if !LISTED.is_repeated(i)
            && let Some(row) = LISTED.first_like(i)
        {
            rows[place] = row;
            place += 1;
        }
        i += 1;
    }
    rows
};

/// The place of the unknown of that name; the number of rows where there is none.
pub(super) const fn place_of(name: &str) -> usize {
    let mut i = 0;
    while i < COUNT && !is_same(TABLE[i].fittable.parameter.name, name) {
        i += 1;
    }
    i
}

/// Whether two texts are the same, also while the program is compiled.
const fn is_same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    let mut i = 0;
    while i < one.len() && i < other.len() && one[i] == other[i] {
        i += 1;
    }
    i == one.len() && i == other.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One unknown has one set of bounds and one scale, whichever law has it.
    #[test]
    fn what_laws_share_is_one_unknown() {
        let all = LISTED.rows.iter().flatten();
        for Row { fittable, home } in all {
            let row = &ROWS[place_of(fittable.parameter.name)];
            assert_eq!((*home, Fittable { parameter: row.fittable.parameter, ..**fittable }), (row.home, *row.fittable));
        }
    }

    #[test]
    fn an_unknown_is_a_parameter_of_what_has_it() {
        let of_laws = PressureSinkage::LAWS.iter().map(|law| (law.parameters, law.fittable));
        let of_laws = of_laws.chain(ShearLaw::LAWS.iter().map(|law| (law.parameters, law.fittable)));
        let of_laws = of_laws.chain(PeakRule::LAWS.iter().map(|law| (law.parameters, law.fittable)));
        let others = [(Soil::PARAMETERS, Soil::FITTABLE), (WheelOnSoil::PARAMETERS, WheelOnSoil::FITTABLE)];
        for (parameters, fittable) in of_laws.chain(others) {
            for Fittable { parameter, bounds: [lower, upper], usual, typical, .. } in fittable {
                assert!(parameters.contains(parameter), "{}", parameter.name);
                assert!(parameter.least <= *lower && *upper <= parameter.most, "{}", parameter.name);
                assert!(lower <= &usual[0] && usual[0] < usual[1] && usual[1] <= *upper, "{}", parameter.name);
                assert!((*lower..=*upper).contains(typical), "{}", parameter.name);
            }
        }
    }
}
