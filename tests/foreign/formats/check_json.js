// SPDX-License-Identifier: Apache-2.0
// check_json.js KIND FILE …: checks each FILE: bills of materials (KIND is cyclonedx) or findings of the checkers (KIND is sarif). Prints
// one line for each fault.
'use strict';

const fs = require('node:fs');
const path = require('node:path');
const Ajv = require('ajv');
const formats = require('ajv-formats');
const CDX = require('@cyclonedx/cyclonedx-library');

function sarifCheck() {
  const folder = path.dirname(require.resolve('@microsoft/jest-sarif/package.json'));
  const schema = JSON.parse(fs.readFileSync(path.join(folder, 'lib/schemas/sarif-2.1.0-rtm.5.json'), 'utf8'));
  delete schema.$schema; // it names draft-04; Ajv has draft-07, which changes nothing that this schema uses
  delete schema.id;
  const ajv = new Ajv({ strict: false, allErrors: true, unicodeRegExp: false });
  formats(ajv);
  const validate = ajv.compile(schema);
  return async (text) => (validate(JSON.parse(text)) ? [] : validate.errors);
}

function cyclonedxCheck() {
  const validator = new CDX.Validation.JsonStrictValidator(CDX.Spec.Version.v1dot6);
  return async (text) => {
    const found = await validator.validate(text);
    return found === null ? [] : found;
  };
}

async function main(words) {
  const checks = { sarif: sarifCheck(), cyclonedx: cyclonedxCheck() };
  let faults = 0;
  for (let at = 0; at + 1 < words.length; at += 2) {
    const [kind, file] = words.slice(at, at + 2);
    for (const fault of await checks[kind](fs.readFileSync(file, 'utf8'))) {
      faults += 1;
      console.log(`${file}: ${fault.instancePath ?? ''} ${fault.message ?? JSON.stringify(fault)}`);
    }
  }
  return faults === 0 ? 0 : 1;
}

main(process.argv.slice(2)).then((status) => process.exit(status));
