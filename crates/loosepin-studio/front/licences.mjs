// Writes the notices of everything that is in the built files. Only packages that are really bundled are named: Vite says which.
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const modules = 'node_modules';
const bundled = JSON.parse(readFileSync('node_modules/.bundled.json', 'utf8'));

const parts = bundled.map((name) => {
  const folder = join(modules, name);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e(\.md|\.txt)?$/i.test(entry));
  if (!file) throw new Error(`${name} has no licence file`);
  const text = readFileSync(join(folder, file), 'utf8').replaceAll('\r\n', '\n').trim();
  return `${name} ${version} (${license})\n\n${text}\n`;
});

const rule = '\n' + '-'.repeat(80) + '\n\n';
writeFileSync('../assets/licences.txt', ['The studio of loosepin contains these packages.\n', ...parts].join(rule));
