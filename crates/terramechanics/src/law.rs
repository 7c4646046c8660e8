//! How does a family of laws know its members? From one list in the family's file; the rest is declared by each law.
//!
//! To add a law, write its file (a struct that implements [`Parametrised`] and [`Declared`], and the methods of the family), and
//! give it a row in the family's `mod.rs`. What the row lacks, the compiler names.

use std::fmt;

use crate::fault::{MissingParameters, completed};
use crate::fittable::Fittable;
use crate::parameter::{Parameter, Parametrised};
use crate::sources::Citation;

/// What the file of a law declares of it, besides its parameters.
pub trait Declared: Parametrised {
    /// Its name for programs.
    const NAME: &'static str;
    /// What it says, in one sentence.
    const DOC: &'static str;
    /// Its formula.
    const FORMULA: &'static str;
    /// Where it comes from.
    const SOURCES: &'static [Citation];
    /// Those of its parameters that a fit may find.
    const FITTABLE: &'static [Fittable] = &[];
}

/// A law of the family `F`: what is known of it before it has values.
pub struct Law<F: 'static> {
    /// Its name for programs.
    pub name: &'static str,
    /// What it says, in one sentence.
    pub doc: &'static str,
    /// Its formula.
    pub formula: &'static str,
    /// Where it comes from.
    pub sources: &'static [Citation],
    /// Its parameters.
    pub parameters: &'static [Parameter],
    /// Those that a fit may find.
    pub fittable: &'static [Fittable],
    make: fn(&[Option<f64>]) -> Option<F>,
}

impl<F> Law<F> {
    /// The law that `L` declares.
    pub(crate) const fn of<L: Declared>() -> Self
    where
        F: From<L>,
    {
        Self {
            name: L::NAME,
            doc: L::DOC,
            formula: L::FORMULA,
            sources: L::SOURCES,
            parameters: L::PARAMETERS,
            fittable: L::FITTABLE,
            make: |values| L::from_values(values).map(F::from),
        }
    }

    /// The law with values in the order of its table; those that are absent have their defaults.
    ///
    /// # Errors
    /// All required parameters without a value.
    pub fn from_values(&self, values: &[Option<f64>]) -> Result<F, MissingParameters> {
        self.made(|i, _| values.get(i).copied().flatten())
    }

    /// The law with values that are found by the name of their parameter.
    ///
    /// # Errors
    /// All required parameters without a value.
    ///
    /// ```
    /// use terramechanics::PressureSinkage;
    /// let law = PressureSinkage::named("direct").expect("a law");
    /// let refused = law.from_named(|name| (name == "n0").then_some(0.9)).expect_err("it has no modulus");
    /// assert_eq!(refused.parameters[0].name, "k_s");
    /// ```
    pub fn from_named(&self, value: impl Fn(&str) -> Option<f64>) -> Result<F, MissingParameters> {
        self.made(|_, parameter| value(parameter.name))
    }

    fn made(&self, value: impl Fn(usize, &'static Parameter) -> Option<f64>) -> Result<F, MissingParameters> {
        let values = completed(self.parameters, value)?;
        // With all that is required, a law is made: a test asks every one.
        (self.make)(&values).ok_or_else(|| MissingParameters { parameters: self.parameters.iter().collect() })
    }
}

impl<F> fmt::Debug for Law<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Law").field("name", &self.name).field("parameters", &self.parameters).finish_non_exhaustive()
    }
}

/// Defines the enum of a family from the list of its laws, with the methods that all of them have.
///
/// A row `Bekker(Bekker)` is a law with parameters, a row `Lyasko` one without; either names the type that declares the law.
macro_rules! family {
    (
        $(#[$attribute:meta])*
        pub enum $family:ident $laws:tt
        $($(#[$doc:meta])* $visibility:vis fn $method:ident(&$this:ident $(, $argument:ident: $type:ty)*) -> $result:ty;)*
    ) => {
        family!(@enum $family $laws $(#[$attribute])*);

        impl $family {
            family!(@laws $laws);

            /// The law of that name.
            #[must_use]
            pub fn named(name: &str) -> Option<&'static $crate::law::Law<Self>> {
                Self::LAWS.iter().find(|law| law.name == name)
            }

            /// What is declared of the law.
            #[must_use]
            pub fn law(&self) -> &'static $crate::law::Law<Self> {
                family!(@law self $laws)
            }

            /// The values of its parameters, in the order of their table.
            #[must_use]
            pub fn values(&self) -> Vec<Option<f64>> {
                use $crate::parameter::Parametrised as _;
                family!(@each self $laws values())
            }

            /// The values that are there, each with its parameter.
            pub fn parameters(&self) -> impl Iterator<Item = (&'static $crate::parameter::Parameter, f64)> + use<> {
                $crate::parameter::present(self.law().parameters, self.values())
            }

            $($(#[$doc])* #[inline] $visibility fn $method(&$this $(, $argument: $type)*) -> $result {
                family!(@each $this $laws $method($($argument),*))
            })*
        }
    };
    (@enum $family:ident { $($(#[$doc:meta])* $law:ident $(($type:ident))?,)+ } $(#[$attribute:meta])*) => {
        $(#[$attribute])*
        pub enum $family {
            $($(#[$doc])* $law $(($type))?,)+
        }

        $(family!(@from $family $law $($type)?);)+
    };
    (@from $family:ident $law:ident) => {
        impl From<$law> for $family {
            fn from(_: $law) -> Self {
                Self::$law
            }
        }
    };
    (@from $family:ident $law:ident $type:ident) => {
        impl From<$type> for $family {
            fn from(law: $type) -> Self {
                Self::$law(law)
            }
        }
    };
    (@laws { $($(#[$doc:meta])* $law:ident $(($type:ident))?,)+ }) => {
        /// Every law of the family.
        pub const LAWS: &'static [$crate::law::Law<Self>] = &[$($crate::law::Law::of::<family!(@type $law $($type)?)>()),+];
    };
    (@law $this:ident { $($(#[$doc:meta])* $law:ident $(($type:ident))?,)+ }) => {
        match $this {
            $(Self::$law $(($type { .. }))? => const { &$crate::law::Law::of::<family!(@type $law $($type)?)>() },)+
        }
    };
    (@each $this:ident { $($(#[$doc:meta])* $law:ident $(($type:ident))?,)+ } $method:ident $arguments:tt) => {
        match $this {
            $(Self::$law $((law @ $type { .. }))? => family!(@either $law law $($type)?).$method $arguments,)+
        }
    };
    (@type $law:ident) => { $law };
    (@type $law:ident $type:ident) => { $type };
    (@either $law:ident $bound:ident) => { $law };
    (@either $law:ident $bound:ident $type:ident) => { $bound };
}
pub(crate) use family;
