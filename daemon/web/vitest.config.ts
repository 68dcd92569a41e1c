import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  root: fileURLToPath(new URL('../../', import.meta.url)).replace(/\/$/, ''),
  cacheDir: 'daemon/web/node_modules/.vite',
  resolve: { preserveSymlinks: true },
  server: { fs: { strict: false } },
  test: { include: ['**/*_test.ts'], testTimeout: 300_000, hookTimeout: 180_000 },
});
