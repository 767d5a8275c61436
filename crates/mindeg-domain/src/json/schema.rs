//! The JSON Schema of domains and models, from the definitions that read and write them.

use schemars::{JsonSchema, schema_for};

use super::{DomainDescription, ModelDescription};

impl DomainDescription {
    /// The JSON Schema of a domain.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::DomainDescription;
    ///
    /// assert!(DomainDescription::schema().contains("size_inside"));
    /// ```
    pub fn schema() -> String {
        schema::<Self>("A domain of mindeg")
    }
}

impl ModelDescription {
    /// The JSON Schema of a model.
    pub fn schema() -> String {
        schema::<Self>("A model of mindeg")
    }
}

fn schema<T: JsonSchema>(title: &str) -> String {
    let mut schema = schema_for!(T);
    schema.insert("title".to_owned(), title.into());
    format!("{schema:#}", schema = schema.to_value())
}
