//! The file of a proof that no mesh has a smaller maximum degree: `mindeg degree --proof` writes it and
//! `mindeg verify --proof` repeats it.

use mindeg::exact::{Element, Literal, Refutation};
use serde::{Deserialize, Serialize};

/// Clauses, each a list of statements of which one or more hold in every mesh that keeps the degree. Each follows from
/// the boundary and the clauses before it by unit propagation (theorem 23 of docs/theory.md); the last one is
/// empty.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProofFile {
    /// No mesh has this maximum degree, or a smaller one.
    pub refuted_degree: u32,
    clauses: Vec<Vec<Statement>>,
}

/// A chord by its two vertices, or a triangle by its three, that a mesh has or lacks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Statement {
    Has(Vec<u32>),
    Lacks(Vec<u32>),
}

impl ProofFile {
    /// The file of a refutation of a degree.
    #[must_use]
    pub fn new(refuted_degree: u32, refutation: &Refutation) -> Self {
        let statement = |literal: &Literal| {
            let vertices = match literal.element {
                Element::Chord(ends) => ends.to_vec(),
                Element::Triangle(corners) => corners.to_vec(),
            };
            if literal.is_used { Statement::Has(vertices) } else { Statement::Lacks(vertices) }
        };
        let clauses = refutation.clauses.iter();
        let clauses = clauses.map(|clause| clause.iter().map(statement).collect()).collect();
        Self { refuted_degree, clauses }
    }

    /// The refutation that it holds.
    ///
    /// # Errors
    ///
    /// A statement on other than two or three vertices, in a sentence.
    pub fn refutation(&self) -> Result<Refutation, String> {
        let literal = |statement: &Statement| {
            let (vertices, is_used) = match statement {
                Statement::Has(vertices) => (vertices, true),
                Statement::Lacks(vertices) => (vertices, false),
            };
            let element = match vertices[..] {
                [a, b] => Element::Chord([a.min(b), a.max(b)]),
                [a, b, c] => Element::Triangle([a, b, c]),
                _ => return Err(format!("{vertices:?} is neither a chord nor a triangle")),
            };
            Ok(Literal { face: 0, element, is_used })
        };
        let clause = |clause: &Vec<Statement>| clause.iter().map(literal).collect();
        Ok(Refutation { clauses: self.clauses.iter().map(clause).collect::<Result<_, _>>()? })
    }
}
