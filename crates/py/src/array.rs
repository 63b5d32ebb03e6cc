//! Numbers and numpy arrays in, broadcast against each other, and arrays out.

use std::borrow::Cow;

use numpy::ndarray::{ArrayD, Dimension, IxDyn};
use numpy::{IntoPyArray, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyOverflowError, PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt};

use crate::error::{Answer, Fail, input, kinds};

/// Most axes of an argument. The bindings hold 32, and a Jacobian has one more than the angles.
const MOST_AXES: usize = 31;

/// An argument: a number, or an array of 64-bit floats.
pub(crate) struct Array<'py> {
    name: &'static str,
    view: PyReadonlyArrayDyn<'py, f64>,
}

impl<'py> Array<'py> {
    /// Takes whatever numpy understands as real numbers; strides and byte order do not matter.
    pub(crate) fn new(name: &'static str, value: &Bound<'py, PyAny>) -> Answer<Self> {
        let py = value.py();
        let numpy = py.import(intern!(py, "numpy"))?;
        refuse_masked(name, value, &numpy)?;
        let given = numpy
            .call_method1(intern!(py, "asarray"), (value,))
            .map_err(|problem| no_array(py, name, problem))?;
        let axes: usize = given.getattr(intern!(py, "ndim"))?.extract()?;
        if axes > MOST_AXES {
            return Err(input(format!("{name} has {axes} axes; it must have at most {MOST_AXES}")));
        }
        let dtype = given.getattr(intern!(py, "dtype"))?;
        let kind: String = dtype.getattr(intern!(py, "kind"))?.extract()?;
        if !matches!(kind.as_str(), "f" | "i" | "u") {
            let message = format!("{name} holds values of type {dtype}; it must hold real numbers");
            return Err(Fail(kinds::InputTypeError::new_err(message)));
        }
        // Aligned, native and of 64 bits: copies only if it is not so already.
        let sound = numpy.call_method1(intern!(py, "require"), (&given, "float64", "A"))?;
        let array = sound.cast_into::<PyArrayDyn<f64>>().map_err(|_| {
            Fail(kinds::InputTypeError::new_err(format!(
                "{name} cannot be read as an array of 64-bit floats"
            )))
        })?;
        let view = array.try_readonly().map_err(|problem| input(format!("{name}: {problem}")))?;
        let found = Self { name, view };
        found.check()?;
        Ok(found)
    }

    /// The same, with a number in place of what was not given.
    pub(crate) fn or(
        py: Python<'py>,
        name: &'static str,
        value: Option<&Bound<'py, PyAny>>,
        default: f64,
    ) -> Answer<Self> {
        match value {
            Some(value) => Self::new(name, value),
            None => Self::new(name, PyFloat::new(py, default).as_any()),
        }
    }

    /// Refuses what is empty or not finite.
    fn check(&self) -> Answer<()> {
        let name = self.name;
        let values = self.view.as_array();
        if values.is_empty() {
            return Err(input(format!(
                "{name} is empty (shape {:?}); give at least one number",
                values.shape()
            )));
        }
        if values.iter().all(|value| value.is_finite()) {
            return Ok(());
        }
        let found = values.indexed_iter().find(|(_, value)| !value.is_finite());
        let Some((at, value)) = found else { return Ok(()) };
        let value = value.to_string().to_lowercase();
        let place = if values.ndim() == 0 { String::new() } else { format!("{:?}", at.slice()) };
        Err(input(format!("{name}{place} is {value}; it must be a finite number")))
    }

    pub(crate) fn shape(&self) -> &[usize] {
        self.view.shape()
    }

    /// The values in order, without a copy if that is how they lie.
    fn flat(&self, shape: &[usize]) -> Answer<Cow<'_, [f64]>> {
        // A slice of columns first would be in the wrong order.
        if self.shape() == shape
            && self.view.is_c_contiguous()
            && let Ok(slice) = self.view.as_slice()
        {
            return Ok(Cow::Borrowed(slice));
        }
        let spread = self.view.as_array();
        let spread = spread.broadcast(IxDyn(shape)).ok_or_else(|| no_match(self, shape))?;
        Ok(Cow::Owned(spread.iter().copied().collect()))
    }

    /// All values of a number or of an array with one axis.
    pub(crate) fn values(&self) -> Answer<Vec<f64>> {
        let shape = self.shape();
        if shape.len() > 1 {
            let name = self.name;
            return Err(input(format!("{name} has shape {shape:?}; it must be a number or have one axis")));
        }
        Ok(self.flat(shape)?.into_owned())
    }

    /// Rows of `N` numbers, the last axis, and the shape of the others.
    pub(crate) fn rows<const N: usize>(&self, of: &str) -> Answer<(Vec<[f64; N]>, Vec<usize>)> {
        let shape = self.shape();
        let Some((_, rest)) = shape.split_last().filter(|(last, _)| **last == N) else {
            let name = self.name;
            return Err(input(format!(
                "{name} has shape {shape:?}; its last axis must have length {N} ({of})"
            )));
        };
        let flat = self.flat(shape)?;
        let (rows, _) = flat.as_chunks::<N>();
        Ok((rows.to_vec(), rest.to_vec()))
    }

    /// Rows of `N` numbers, the last axis, spread out to a shape of the others.
    fn rows_of<const N: usize>(&self, rest: &[usize]) -> Answer<Vec<[f64; N]>> {
        let shape: Vec<usize> = rest.iter().copied().chain([N]).collect();
        let flat = self.flat(&shape)?;
        let (rows, _) = flat.as_chunks::<N>();
        Ok(rows.to_vec())
    }

    /// One row of `N` numbers.
    pub(crate) fn row<const N: usize>(&self, of: &str) -> Answer<[f64; N]> {
        match self.rows::<N>(of)? {
            (rows, rest) if rest.is_empty() => Ok(rows[0]),
            _ => {
                let (name, shape) = (self.name, self.shape());
                Err(input(format!("{name} has shape {shape:?}; it must be ({N},): {of}")))
            }
        }
    }
}

type Rows<const N: usize> = Vec<[f64; N]>;

/// Rows of `N` numbers of two arrays, and the shape that all axes but the last have together, by numpy's rules.
pub(crate) fn rows_together<const N: usize>(
    (first, of_first): (&Array<'_>, &str),
    (second, of_second): (&Array<'_>, &str),
) -> Answer<([Rows<N>; 2], Vec<usize>)> {
    first.rows::<N>(of_first)?;
    second.rows::<N>(of_second)?;
    let mut shape = common_shape(&[first, second])?;
    shape.pop();
    Ok(([first.rows_of(&shape)?, second.rows_of(&shape)?], shape))
}

/// The ends of an interval: a tuple, list or array of two numbers.
pub(crate) fn interval(name: &'static str, value: &Bound<'_, PyAny>) -> Answer<(f64, f64)> {
    let array = Array::new(name, value)?;
    let shape = array.shape();
    match (shape, array.flat(shape)?.as_ref()) {
        ([2], &[low, high]) => Ok((low, high)),
        ([], &[only]) => Err(Fail(kinds::InputTypeError::new_err(format!(
            "{name} is the number {only}; it must be two numbers, the ends of an interval"
        )))),
        _ => {
            Err(input(format!("{name} has shape {shape:?}; it must be two numbers, the ends of an interval")))
        }
    }
}

/// The same for one that need not be given.
pub(crate) fn interval_or_none(
    name: &'static str,
    value: Option<&Bound<'_, PyAny>>,
) -> Answer<Option<(f64, f64)>> {
    value.map(|value| interval(name, value)).transpose()
}

/// Refuses arrays with masked elements: `asarray` would take the numbers behind the mask.
fn refuse_masked(name: &str, value: &Bound<'_, PyAny>, numpy: &Bound<'_, PyModule>) -> Answer<()> {
    // Most arguments are numbers.
    if value.is_exact_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>() {
        return Ok(());
    }
    let py = value.py();
    let masked = numpy.getattr(intern!(py, "ma"))?;
    if !value.is_instance(&masked.getattr(intern!(py, "MaskedArray"))?)? {
        return Ok(());
    }
    if masked.call_method1(intern!(py, "is_masked"), (value,))?.is_truthy()? {
        return Err(input(format!(
            "{name} has masked elements, which have no value; leave them out or fill them"
        )));
    }
    Ok(())
}

/// What numpy made no array of. Whatever else was raised on the way, Ctrl-C or a lack of memory, is no matter of the argument.
fn no_array(py: Python<'_>, name: &str, problem: PyErr) -> Fail {
    let message = format!("{name} is no array: {}", problem.value(py));
    let refused = if problem.is_instance_of::<PyTypeError>(py) {
        kinds::InputTypeError::new_err(message)
    } else if problem.is_instance_of::<PyValueError>(py) {
        kinds::InputError::new_err(message)
    } else {
        return Fail(problem);
    };
    refused.set_cause(py, Some(problem));
    Fail(refused)
}

fn no_match(array: &Array<'_>, shape: &[usize]) -> Fail {
    let (name, own) = (array.name, array.shape());
    input(format!(
        "{name} has shape {own:?}, which does not go with the others' {shape:?}; see numpy's broadcasting"
    ))
}

/// The shape that all arrays have together, by numpy's rules.
pub(crate) fn common_shape(arrays: &[&Array<'_>]) -> Answer<Vec<usize>> {
    let mut shape: Vec<usize> = Vec::new();
    for array in arrays {
        let own = array.shape();
        while shape.len() < own.len() {
            shape.insert(0, 1);
        }
        let skip = shape.len() - own.len();
        for (wanted, &have) in shape[skip..].iter_mut().zip(own) {
            if *wanted == 1 {
                *wanted = have;
            } else if have != 1 && have != *wanted {
                return Err(no_match(array, arrays[0].shape()));
            }
        }
    }
    Ok(shape)
}

/// An argument with the value that each element has; a number is not spread out.
pub(crate) enum Column<'a> {
    One(f64),
    Many(Cow<'a, [f64]>),
}

impl<'a> Column<'a> {
    pub(crate) fn new(array: &'a Array<'_>, shape: &[usize]) -> Answer<Self> {
        let values = array.view.as_array();
        match values.iter().next() {
            Some(&only) if values.len() == 1 => Ok(Self::One(only)),
            _ => Ok(Self::Many(array.flat(shape)?)),
        }
    }

    pub(crate) fn at(&self, index: usize) -> f64 {
        match self {
            Self::One(value) => *value,
            Self::Many(values) => values[index],
        }
    }
}

/// A float for an empty shape, otherwise an array that takes the values over.
pub(crate) fn shaped<'py>(py: Python<'py>, values: Vec<f64>, shape: &[usize]) -> Answer<Bound<'py, PyAny>> {
    if shape.is_empty()
        && let [only] = values.as_slice()
    {
        return Ok(PyFloat::new(py, *only).into_any());
    }
    let array = ArrayD::from_shape_vec(IxDyn(shape), values).map_err(|problem| input(problem.to_string()))?;
    Ok(array.into_pyarray(py).into_any())
}

/// The index of an element for a message, in the axes of the shape; nothing for a single number.
pub(crate) fn place(mut index: usize, shape: &[usize]) -> String {
    if shape.is_empty() {
        return String::new();
    }
    let mut places: Vec<usize> = shape
        .iter()
        .rev()
        .map(|&length| {
            let at = index % length;
            index /= length;
            at
        })
        .collect();
    places.reverse();
    format!("element {places:?}: ")
}

/// A whole number that is not negative, of at most 64 bits, as an argument: Python's integers have no bounds.
pub(crate) fn whole<'py, T>(value: &Bound<'py, PyAny>) -> PyResult<T>
where
    T: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    value.extract().map_err(|problem: PyErr| {
        if problem.is_instance_of::<PyOverflowError>(value.py()) {
            let most = u64::MAX >> (u64::BITS as usize - 8 * size_of::<T>());
            kinds::InputError::new_err(format!("{value} is out of range; it must be from 0 to {most}"))
        } else {
            problem
        }
    })
}

/// The same for one that need not be given.
pub(crate) fn whole_or_none(value: &Bound<'_, PyAny>) -> PyResult<Option<u64>> {
    if value.is_none() { Ok(None) } else { whole(value).map(Some) }
}
