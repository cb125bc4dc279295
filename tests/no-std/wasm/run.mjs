// Prints the hashes that the module given as the only argument computes.
import { readFileSync } from "node:fs";

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]));
const { hash, aimed } = instance.exports;
console.log([hash(), aimed()].map((bits) => BigInt.asUintN(64, bits).toString(16).padStart(16, "0")).join(" "));
