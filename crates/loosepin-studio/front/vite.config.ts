import { svelte } from '@sveltejs/vite-plugin-svelte';
import { writeFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';
import { glossary } from './glossary.ts';

/** Tells licences.mjs which packages are in the built files. */
function bundledPackages(): Plugin {
  return {
    name: 'bundled-packages',
    generateBundle(_options, bundle) {
      const names = new Set<string>();
      for (const file of Object.values(bundle)) {
        if (file.type !== 'chunk') continue;
        for (const [module, part] of Object.entries(file.modules)) {
          const name = /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(module)?.[1];
          if (name !== undefined && part.renderedLength > 0) names.add(name);
        }
      }
      writeFileSync('node_modules/.bundled.json', JSON.stringify([...names].sort()));
    },
  };
}

// The server embeds these files by name: so no hashes, and one chunk that is loaded when a text is first shown.
export default defineConfig({
  base: './',
  plugins: [svelte(), glossary(), bundledPackages()],
  build: {
    target: 'es2022',
    outDir: '../assets',
    emptyOutDir: true,
    modulePreload: false,
    cssCodeSplit: false,
    sourcemap: false,
    reportCompressedSize: false,
    rolldownOptions: {
      output: { entryFileNames: 'studio.js', chunkFileNames: 'editor.js', assetFileNames: 'studio[extname]' },
    },
  },
});
