import { mount } from 'svelte';
import App from './App.svelte';
import { addressOf, router } from './shell/route.svelte.ts';
import { session } from './network/session.svelte.ts';
import './studio.css';
import { takeToken } from './network/wire.ts';

takeToken('#/');
router.start(() => {
  // What is not saved goes on with the new key.
  takeToken(addressOf(router.route));
  session.restart();
});
session.start();
const target = document.getElementById('studio');
if (target) mount(App, { target });
