// SPDX-License-Identifier: Apache-2.0
// eds_check.js FILE.eds FILE.json: reads FILE.eds with the EDS parser of the npm package `canopen`, and compares every entry
// with FILE.json, the dictionary as `canproof eds --format json` writes it from the requirements register.
const fs = require('fs');
const { Eds } = require('canopen/source/eds');
const { AccessType, DataType } = require('canopen/source/types');

const [edsFile, jsonFile] = process.argv.slice(2);
const wanted = JSON.parse(fs.readFileSync(jsonFile));
const eds = Eds.fromFile(edsFile);
const faults = [];
let entries = 0;

function compare(where, what, found, expected) {
    if (found !== expected) {
        faults.push(`${where}: ${what} is ${found}, not ${expected}`);
    }
}

// Returns the number that a text of the EDS represents. Returns any other text unchanged.
function number(text) {
    return typeof text === 'string' && text.trim() !== '' && !Number.isNaN(Number(text)) ? Number(text) : text;
}

function access(entry) {
    if (entry.access !== 'rw') {
        return entry.access;
    }
    return { tpdo: 'rwr', rpdo: 'rww' }[entry.mapping] ?? 'rw';
}

function compareEntry(where, found, entry) {
    ++entries;
    if (!found) {
        faults.push(`${where}: not there`);
        return;
    }
    compare(where, 'type', found.dataType, DataType[entry.type]);
    compare(where, 'access', found.accessType, access(entry));
    if (entry.type === 'DOMAIN') {
        return;
    }
    compare(where, 'mapping', Boolean(Number(found.pdoMapping ?? 0)), (entry.mapping ?? 'none') !== 'none');
    const isText = entry.type === 'VISIBLE_STRING' || entry.type === 'OCTET_STRING';
    const isTerm = typeof entry.default === 'string' && entry.default.startsWith('$NODEID');
    if (isTerm) {
        compare(where, 'node-ID term', Number(String(found.defaultValue).split('+')[1]), Number(entry.default.split('+')[1]));
    } else if (!isText) {
        compare(where, 'default', number(found.defaultValue), Number(entry.default));
    }
    for (const [key, limit] of [['minimum', found.lowLimit], ['maximum', found.highLimit]]) {
        // An EDS contains no limits of a REAL32, see write_eds.cpp.
        if (typeof entry[key] === 'number' && !entry.zero && !entry.type.startsWith('REAL')) {
            compare(where, key, number(limit) ?? 0, entry[key]);  // this parser drops a limit that is 0
        }
    }
}

for (const object of wanted.objects) {
    const index = Number(object.index);
    const found = eds.getEntry(index);
    if (!found) {
        faults.push(`${object.index}: not there`);
        continue;
    }
    compare(object.index, 'name', found.parameterName, object.name);
    if (object.kind === 'VAR') {
        compareEntry(object.index, found, object.entries[0]);
        continue;
    }
    compare(object.index, 'number of entries', Number(found.subNumber), object.entries.length);
    for (const entry of object.entries) {
        compareEntry(`${object.index}:${entry.subindex}`, found[entry.subindex], entry);
    }
}

for (const fault of faults.slice(0, 50)) {
    console.error(`${edsFile}: ${fault}`);
}
console.log(`${edsFile}: ${wanted.objects.length} objects, ${entries} entries, ${faults.length} fault(s)`);
process.exit(faults.length === 0 && entries > 0 ? 0 : 1);
