// SPDX-License-Identifier: Apache-2.0
// Runs a WASI program under node: node --no-warnings wasi.mjs PROGRAM.wasm [ARGUMENT…]
// Paths of the arguments must be absolute: WASI has no working directory.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const args = process.argv.slice(2);
const wasi = new WASI({ version: 'preview1', args, preopens: { '/': '/' }, returnOnExit: true });
const { instance } = await WebAssembly.instantiate(await readFile(args[0]), wasi.getImportObject());
process.exitCode = wasi.start(instance);
