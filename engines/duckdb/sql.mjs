// SPDX-License-Identifier: Apache-2.0
// node sql.mjs [SETTING=VALUE]... <statements: runs them with the extension loaded; rows of the last one come as JSON. An
// error is told, and the statements after it are run.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import process from 'node:process';

const { DuckDBInstance } = createRequire(`${process.cwd()}/`)('@duckdb/node-api');
const settings = Object.fromEntries(process.argv.slice(2).map((argument) => argument.split('=')));
const { database = ':memory:', ...rest } = settings;
const instance = await DuckDBInstance.create(database, { allow_unsigned_extensions: 'true', ...rest });
const connection = await instance.connect();
await connection.run("LOAD './vesica.duckdb_extension'");
for (const statement of readFileSync(0, 'utf8').split(/;\s*\n/)) {
  if (!statement.trim()) continue;
  try {
    const reader = await connection.runAndReadAll(statement);
    for (const row of reader.getRowsJson()) console.log(JSON.stringify(row));
  } catch (error) {
    console.log(error.message);
  }
}
