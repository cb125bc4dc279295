// Prints the hash that the module given as the only argument computes.
import { readFileSync } from "node:fs";

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]));
console.log(BigInt.asUintN(64, instance.exports.hash()).toString(16).padStart(16, "0"));
