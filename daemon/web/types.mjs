// Writes state/channels.ts: the types of the daemon's messages, from the schemas of its channels.
import { readFileSync, writeFileSync } from 'node:fs';

const at = (path) => new URL(path, import.meta.url);

/** @returns {string} the type in TypeScript */
function typeOf(schema, indent) {
  if (schema.enum) return schema.enum.map((name) => `'${name}'`).join(' | ');
  if (schema.type === 'array') return `Array<${typeOf(schema.items, indent)}>`;
  if (schema.type !== 'object') return schema.type;
  if (Object.keys(schema.properties).length === 0) return 'Record<string, unknown>';
  const inner = `${indent}  `;
  const fields = Object.entries(schema.properties).map(([name, property]) => {
    const left_out = schema.required !== undefined && !schema.required.includes(name);
    return `${inner}${name}${left_out ? '?' : ''}: ${typeOf(property, inner)}${left_out ? ' | undefined' : ''};\n`;
  });
  return `{\n${fields.join('')}${indent}}`;
}

const schemas = Object.entries(JSON.parse(readFileSync(at('../messages/schemas.json'), 'utf8')));
const channels = schemas.map(([topic, schema]) => `  '${topic}': ${typeOf(schema, '  ')};\n`);
writeFileSync(at('state/channels.ts'), `// Written by types.mjs.
/* eslint-disable @typescript-eslint/array-type */

/** The message of each channel (daemon/messages/CHANNELS.md). SI units, REP-103 frames. */
export interface Channels {
${channels.join('')}}
`);
