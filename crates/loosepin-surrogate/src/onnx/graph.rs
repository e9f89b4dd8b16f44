//! The graph of a surrogate that is made of networks. Numbers of fields are those of `onnx.proto`.

use super::super::fitted::{Fitted, Form};
use super::super::input::Input;
use super::super::modes::Modes;
use super::OnnxMetadata;
use super::protobuf::Message;

/// Version of the layout (of 2022), and of the operators that are used.
const IR_VERSION: i64 = 8;
const OPERATOR_SET: i64 = 17;
/// `TensorProto.DOUBLE` and `AttributeProto.INT`.
const DOUBLE: i64 = 11;
const INTEGER_ATTRIBUTE: i64 = 2;

/// A matrix by rows.
struct Matrix {
    rows: usize,
    columns: usize,
    values: Vec<f64>,
}

impl Matrix {
    fn zero(rows: usize, columns: usize) -> Self {
        Self { rows, columns, values: vec![0.0; rows * columns] }
    }

    fn set(&mut self, row: usize, column: usize, value: f64) {
        self.values[row * self.columns + column] = value;
    }
}

/// The neurons of all modes side by side, and the scores that they add up to.
pub(crate) struct Layers {
    /// W, a column a neuron.
    hidden: Matrix,
    /// b
    hidden_offset: Vec<f64>,
    /// V, a column a mode.
    outer: Matrix,
    /// v
    outer_offset: Vec<f64>,
    /// μ and σ of each mode.
    mean: Vec<f64>,
    deviation: Vec<f64>,
}

impl Layers {
    /// The graph of the fits of all modes over `inputs` inputs; an error with the first fit that is no network. A constant is one without
    /// neurons.
    pub fn new(fits: &[Fitted], inputs: usize) -> Result<Self, &Fitted> {
        if let Some(other) = fits.iter().find(|fit| !matches!(fit.form(), Form::Network(_) | Form::Constant)) {
            return Err(other);
        }
        let networks = |fit: &Fitted| match fit.form() {
            Form::Network(ensemble) => ensemble.networks.clone(),
            _ => Vec::new(),
        };
        let neurons: usize = fits.iter().flat_map(networks).map(|network| network.neurons()).sum();
        // A matrix has a column: one of zeros where there is no neuron.
        let mut layers = Self {
            hidden: Matrix::zero(inputs, neurons.max(1)),
            hidden_offset: vec![0.0; neurons.max(1)],
            outer: Matrix::zero(neurons.max(1), fits.len()),
            outer_offset: vec![0.0; fits.len()],
            mean: fits.iter().map(|fit| fit.scale().0).collect(),
            deviation: fits.iter().map(|fit| fit.scale().1).collect(),
        };
        let mut neuron = 0;
        for (mode, fit) in fits.iter().enumerate() {
            let networks = networks(fit);
            let share = 1.0 / networks.len().max(1) as f64;
            for network in &networks {
                let (rows, outer) = network.weights().split_at(network.neurons() * (inputs + 1));
                layers.outer_offset[mode] += share * outer[0];
                for (row, v) in rows.chunks(inputs + 1).zip(&outer[1..]) {
                    layers.hidden_offset[neuron] = row[0];
                    for (input, weight) in row[1..].iter().enumerate() {
                        layers.hidden.set(input, neuron, *weight);
                    }
                    layers.outer.set(neuron, mode, share * v);
                    neuron += 1;
                }
            }
        }
        Ok(layers)
    }
}

/// The file of `layers` over `inputs`, answering within `ranges`, with the curve of `modes`.
pub(crate) fn model(
    name: &str,
    (inputs, ranges): (&[Input], &[(f64, f64)]),
    layers: Layers,
    modes: &Modes,
    metadata: OnnxMetadata,
) -> Vec<u8> {
    let places = modes.mean.len();
    let mut shapes = Matrix::zero(modes.shapes.len(), places);
    for (row, shape) in modes.shapes.iter().enumerate() {
        shape.iter().enumerate().for_each(|(place, value)| shapes.set(row, place, *value));
    }
    let each = |of: fn(&Input) -> f64| inputs.iter().map(of).collect();
    let ones = Matrix { rows: inputs.len(), columns: 1, values: vec![1.0; inputs.len()] };
    let initializer = vec![
        vector("least", ranges.iter().map(|range| range.0).collect()),
        vector("largest", ranges.iter().map(|range| range.1).collect()),
        matrix("ones", ones),
        vector("zero", vec![0.0]),
        vector("no_answer", vec![f64::NAN]),
        vector("input_centre", each(|input| input.centre_and_factor().0)),
        vector("input_factor", each(|input| input.centre_and_factor().1)),
        matrix("hidden_weights", layers.hidden),
        vector("hidden_offset", layers.hidden_offset),
        matrix("outer_weights", layers.outer),
        vector("outer_offset", layers.outer_offset),
        vector("score_deviation", layers.deviation),
        vector("score_mean", layers.mean),
        matrix("mode_shapes", shapes),
        vector("mean_curve", modes.mean.clone()),
    ];
    let node = vec![
        step("Less", &["inputs", "least"], "is_below"),
        step("Greater", &["inputs", "largest"], "is_above"),
        step("Or", &["is_below", "is_above"], "is_beyond"),
        step("Cast", &["is_beyond"], "beyond").message(5, to_double()),
        step("MatMul", &["beyond", "ones"], "inputs_beyond"),
        step("Greater", &["inputs_beyond", "zero"], "is_outside"),
        step("Sub", &["inputs", "input_centre"], "centred"),
        step("Mul", &["centred", "input_factor"], "scaled"),
        step("MatMul", &["scaled", "hidden_weights"], "weighted"),
        step("Add", &["weighted", "hidden_offset"], "arguments"),
        step("Tanh", &["arguments"], "neurons"),
        step("MatMul", &["neurons", "outer_weights"], "added"),
        step("Add", &["added", "outer_offset"], "standard_scores"),
        step("Mul", &["standard_scores", "score_deviation"], "centred_scores"),
        step("Add", &["centred_scores", "score_mean"], "scores"),
        step("MatMul", &["scores", "mode_shapes"], "deviation_from_mean_curve"),
        step("Add", &["deviation_from_mean_curve", "mean_curve"], "learned"),
        step("Where", &["is_outside", "no_answer", "learned"], "values"),
    ];
    // GraphProto: node, name, initializer, input, output
    let graph = Message::default()
        .messages(1, node)
        .text(2, name)
        .messages(5, initializer)
        .message(11, value("inputs", inputs.len()))
        .message(12, value("values", places));
    // OperatorSetIdProto: version; StringStringEntryProto: key, value
    let operators = Message::default().integer(2, OPERATOR_SET);
    let metadata = metadata.iter().map(|(key, value)| Message::default().text(1, key).text(2, value));
    // ModelProto: ir_version, producer_name, producer_version, graph, opset_import, metadata_props
    Message::default()
        .integer(1, IR_VERSION)
        .text(2, "loosepin")
        .text(3, env!("CARGO_PKG_VERSION"))
        .message(7, graph)
        .message(8, operators)
        .messages(14, metadata)
        .into_bytes()
}

fn vector(name: &str, values: Vec<f64>) -> Message {
    tensor(name, &[values.len() as i64], &values)
}

fn matrix(name: &str, matrix: Matrix) -> Message {
    tensor(name, &[matrix.rows as i64, matrix.columns as i64], &matrix.values)
}

/// TensorProto: dims, data_type, name, double_data
fn tensor(name: &str, dims: &[i64], values: &[f64]) -> Message {
    Message::default().integers(1, dims).integer(2, DOUBLE).text(8, name).doubles(10, values)
}

/// NodeProto: input, output, op_type
fn step(operator: &str, from: &[&str], to: &str) -> Message {
    Message::default().texts(1, from).text(2, to).text(4, operator)
}

/// AttributeProto: name, i, type
fn to_double() -> Message {
    Message::default().text(1, "to").integer(3, DOUBLE).integer(20, INTEGER_ATTRIBUTE)
}

/// A table with any number of rows.
fn value(name: &str, columns: usize) -> Message {
    // TensorShapeProto.Dimension: dim_value or dim_param
    let dims = [Message::default().text(2, "batch"), Message::default().integer(1, columns as i64)];
    // TypeProto.Tensor: elem_type, shape
    let tensor = Message::default().integer(1, DOUBLE).message(2, Message::default().messages(1, dims));
    // ValueInfoProto: name, type
    Message::default().text(1, name).message(2, Message::default().message(1, tensor))
}
