// The rules of Psych-DS, written from its specification and apart from what exports: what is wrong with a data set?
//
//   1. dataset_description.json in the root: a JSON object in UTF-8 of schema.org's type Dataset, with name,
//   description
//      and variableMeasured, which holds names or PropertyValues.
//   2. data/ holds at least one file whose name is KEY-VALUE pairs joined by _ and ends in _data.csv: keys are small
//      letters, values letters and digits. No other CSV file is in it.
//   3. Each of them is UTF-8 with one line of column names, each once and none empty; every line has as many fields.
//   4. Every column is in variableMeasured.
//   5. In a column row_id no value is empty or comes twice.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ocelli::test {

/// One line a violation, each beginning with the file; empty where the folder keeps all rules.
std::vector<std::string> psychDsViolations(const std::filesystem::path& folder);

}  // namespace ocelli::test
