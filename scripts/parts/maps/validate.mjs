// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks GLB files with Khronos's validator from npm: node validate.mjs FOLDER_OF_GLTF_VALIDATOR FILE ...
// Prints one line of JSON for each file: its errors, warnings and first messages.
import {createRequire} from "node:module";
import {readFileSync} from "node:fs";
import {resolve} from "node:path";

const [validator_folder, ...files] = process.argv.slice(2);
const validator = createRequire(import.meta.url)(resolve(validator_folder, "index.js"));
for (const file of files) {
  const {issues} = await validator.validateBytes(new Uint8Array(readFileSync(file)), {maxIssues: 100});
  issues.messages.sort((a, b) => a.severity - b.severity);
  const messages = issues.messages.slice(0, 5).map(({code, severity, message, pointer}) => ({code, severity, message, pointer}));
  console.log(JSON.stringify({file, errors: issues.numErrors, warnings: issues.numWarnings, infos: issues.numInfos, messages}));
}
