//! `mindeg schema`: the JSON Schema of domains and models.

use crate::args::SchemaArguments;
use crate::failure::Failure;
use crate::standard_output::print;
use mindeg::{DomainDescription, ModelDescription};

pub(crate) fn run(arguments: &SchemaArguments) -> Result<(), Failure> {
    let schema =
        if arguments.model { ModelDescription::schema() } else { DomainDescription::schema() };
    print(&format!("{schema}\n"))
}
