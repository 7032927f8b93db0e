// Runs the audit program's WebAssembly under Node.js: node run.mjs audit.wasm

import { readFileSync, writeSync } from "node:fs";

let memory;
const print = (bytes, length) => {
  const end = bytes + length;
  while (bytes < end) {
    bytes += writeSync(1, new Uint8Array(memory.buffer, bytes, end - bytes));
  }
};
const program = readFileSync(process.argv[2]);
const { instance } = await WebAssembly.instantiate(program, { audit: { print } });
memory = instance.exports.memory;
process.exitCode = instance.exports.audit();
