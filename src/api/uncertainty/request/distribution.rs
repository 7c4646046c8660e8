//! The distribution of a field, as a client writes it.

use terramechanics_reading::{Field, Number, Numbers, Reader, Word};
use terramechanics_uncertainty::{Distribution, InputError, MOST_VALUES};

use crate::warning::listed;

/// The form of a distribution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Normal,
    LogNormal,
    Uniform,
    Triangular,
    Quantiles,
    Samples,
}

pub(super) const FORM: Field<Word<Form>> = Field::required(
    "distribution",
    "normal and lognormal: `mean` and `standard_deviation` of the quantity itself; uniform: `low` and `high`; triangular: `low`, `mode` and `high`; each also by `relative` alone. quantiles: `values` at even steps of probability from 0 to 1. samples: `values`, joint with those of all other fields that have samples.",
    Word::new(&[
        ("normal", Form::Normal),
        ("lognormal", Form::LogNormal),
        ("uniform", Form::Uniform),
        ("triangular", Form::Triangular),
        ("quantiles", Form::Quantiles),
        ("samples", Form::Samples),
    ]),
);
const MEAN: Field<Number> = Field::new("mean", "Mean, before what is outside the field's bounds is cut off.", Number::any(""));
const DEVIATION: Field<Number> = Field::new("standard_deviation", "Standard deviation, before that.", Number::any(""));
const RELATIVE: Field<Number> = Field::new(
    "relative",
    "In place of the other parameters, a share of the value that the request has for the field: its own, that of its preset, or with `assume` the substitute of one that was never published. That value is the mean, the middle of a uniform or the mode of a triangular distribution; the share of it is the standard deviation of a normal or lognormal, and half the width of a uniform or triangular one.",
    Number::new("1", 0.0, 10.0),
);
const LOW: Field<Number> = Field::new("low", "Lower end.", Number::any(""));
const MODE: Field<Number> = Field::new("mode", "Where the density is largest.", Number::any(""));
const HIGH: Field<Number> = Field::new("high", "Upper end.", Number::any(""));
const VALUES: Field<Numbers> = Field::new(
    "values",
    "Quantiles in ascending order, or samples. Samples of several fields are rows: the first of one belongs to the first of the others, and a row is drawn as a whole.",
    Numbers::new(Number::any(""), 2, MOST_VALUES),
);

pub(super) const PARAMETERS: terramechanics_reading::Group = &[&MEAN, &DEVIATION, &RELATIVE, &LOW, &MODE, &HIGH, &VALUES];

/// The parameters that are numbers.
const NUMBERS: [&Field<Number>; 5] = [&MEAN, &DEVIATION, &LOW, &MODE, &HIGH];

impl Form {
    /// Its name on the wire.
    pub(super) fn name(self) -> &'static str {
        FORM.kind.words.iter().find(|(_, form)| *form == self).map_or("", |(name, _)| name)
    }

    /// The numbers that it takes.
    fn takes(self) -> &'static [&'static Field<Number>] {
        match self {
            Self::Normal | Self::LogNormal => &[&MEAN, &DEVIATION],
            Self::Uniform => &[&LOW, &HIGH],
            Self::Triangular => &[&LOW, &MODE, &HIGH],
            Self::Quantiles | Self::Samples => &[],
        }
    }

    fn takes_values(self) -> bool {
        self.takes().is_empty()
    }

    /// What it takes, in words.
    fn in_words(self) -> String {
        match self.takes() {
            [] => "`values`".to_owned(),
            _ => format!("{}, or `{}` alone", self.parameters(), RELATIVE.name),
        }
    }

    /// Its parameters that are numbers, in words.
    fn parameters(self) -> String {
        let names: Vec<String> = self.takes().iter().map(|field| format!("`{}`", field.name)).collect();
        listed(&names)
    }
}

/// A distribution that was read.
pub(super) enum Given {
    One(Distribution),
    /// Samples, joint with those of other fields.
    Samples(Vec<f64>),
}

/// The distribution of a field that may have `number`, and has the value `nominal` in the request.
pub(super) fn read(input: &Reader<'_>, number: Option<&Number>, nominal: Option<f64>) -> Option<Given> {
    let form = input.required(&FORM);
    let numbers = NUMBERS.map(|field| input.optional(field));
    let (relative, values) = (input.optional(&RELATIVE), input.optional(&VALUES));
    let form = form?;
    let takes = |field: &Field<Number>| form.takes().iter().any(|taken| taken.name == field.name);
    let mut is_sound = true;
    let mut refuse = |name: &'static str, detail: String| {
        is_sound = false;
        input.place().field(name).fault(detail);
    };
    for field in NUMBERS.into_iter().filter(|field| input.has(field)) {
        if !takes(field) {
            refuse(field.name, format!("is no parameter of `{}`, which takes {}", form.name(), form.in_words()));
        } else if input.has(&RELATIVE) {
            refuse(field.name, format!("give either this or `{}`", RELATIVE.name));
        }
    }
    if input.has(&VALUES) != form.takes_values() {
        refuse(
            VALUES.name,
            if form.takes_values() {
                "is required".to_owned()
            } else {
                format!("is no parameter of `{}`, which takes {}", form.name(), form.in_words())
            },
        );
    }
    if input.has(&RELATIVE) && form.takes_values() {
        refuse(RELATIVE.name, format!("is no parameter of `{}`, which takes {}", form.name(), form.in_words()));
    }
    if !input.has(&RELATIVE) {
        for field in form.takes().iter().filter(|field| !input.has(field)) {
            refuse(field.name, format!("is required; `{}` takes {}", form.name(), form.in_words()));
        }
    }
    let values = values?;
    if let (Some(number), Some(values)) = (number, values) {
        let place = input.place_of(&VALUES);
        for (i, value) in values.iter().enumerate().filter(|(_, value)| !number.allows(**value)).take(MOST_FAULTS) {
            is_sound &= number.check(&place.item(i), *value).is_some();
        }
    }
    let [mean, deviation, low, mode, high] = numbers;
    let (mean, deviation, low, mode, high) = (mean?, deviation?, low?, mode?, high?);
    let relative = relative?;
    if !is_sound {
        return None;
    }
    if let Some(values) = values {
        let values = values.to_vec();
        return Some(if form == Form::Samples { Given::Samples(values) } else { Given::One(Distribution::Quantiles { values }) });
    }
    if let Some(relative) = relative {
        return of_relative(input, form, relative, nominal).map(Given::One);
    }
    Some(Given::One(match form {
        Form::Normal => Distribution::Normal { mean: mean?, deviation: deviation? },
        Form::LogNormal => Distribution::LogNormal { mean: mean?, deviation: deviation? },
        Form::Uniform => Distribution::Uniform { low: low?, high: high? },
        Form::Triangular => Distribution::Triangular { low: low?, mode: mode?, high: high? },
        Form::Quantiles | Form::Samples => return None,
    }))
}

/// Faults of one list that are told.
const MOST_FAULTS: usize = 10;

/// The distribution about the value that the request has.
fn of_relative(input: &Reader<'_>, form: Form, relative: f64, nominal: Option<f64>) -> Option<Distribution> {
    let place = input.place_of(&RELATIVE);
    let Some(nominal) = nominal else {
        place.fault(format_args!(
            "needs a value of the field to be relative to, and the request has none, itself or by a preset; give {}",
            form.parameters()
        ));
        return None;
    };
    let width = relative * nominal.abs();
    if width == 0.0 {
        let reason = if nominal == 0.0 { ", because the request has 0 for the field" } else { "" };
        place.fault(format_args!("makes no width{reason}; give {}", form.parameters()));
        return None;
    }
    let (low, high) = (nominal - width, nominal + width);
    Some(match form {
        Form::Normal => Distribution::Normal { mean: nominal, deviation: width },
        Form::LogNormal => Distribution::LogNormal { mean: nominal, deviation: width },
        Form::Triangular => Distribution::Triangular { low, mode: nominal, high },
        Form::Uniform | Form::Quantiles | Form::Samples => Distribution::Uniform { low, high },
    })
}

/// Whether the distribution of an input lies about the value of the request.
pub(super) fn is_relative(input: &Reader<'_>) -> bool {
    input.has(&RELATIVE)
}

/// Reports what the distribution lacks, at the parameter that is to blame.
pub(super) fn report(input: &Reader<'_>, error: InputError) {
    let name = match error {
        _ if input.has(&RELATIVE) => RELATIVE.name,
        InputError::Deviation { .. } => DEVIATION.name,
        InputError::Mean { .. } => MEAN.name,
        InputError::Mode { .. } => MODE.name,
        InputError::Ends { .. } => HIGH.name,
        InputError::Order { .. } | InputError::Count { .. } | InputError::Lengths { .. } => VALUES.name,
        InputError::NotFinite | InputError::TooWide | InputError::Outside { .. } | InputError::MostlyOutside { .. } => FORM.name,
    };
    input.place().field(name).fault(error);
}

/// The form of a distribution that comes from the model of uncertainty.
pub(crate) fn form_of(distribution: &Distribution) -> &'static str {
    match distribution {
        Distribution::Normal { .. } => Form::Normal,
        Distribution::LogNormal { .. } => Form::LogNormal,
        Distribution::Uniform { .. } => Form::Uniform,
        Distribution::Triangular { .. } => Form::Triangular,
        Distribution::Quantiles { .. } => Form::Quantiles,
    }
    .name()
}

/// What joint samples are called.
pub(crate) fn form_of_samples() -> &'static str {
    Form::Samples.name()
}
