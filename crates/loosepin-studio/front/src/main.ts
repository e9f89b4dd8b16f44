import { mount } from 'svelte';
import App from './App.svelte';
import { router } from './shell/route.svelte.ts';
import { session } from './network/session.svelte.ts';
import './studio.css';
import { takeToken } from './network/wire.ts';

takeToken();
router.start(() => location.reload());
session.start();
const target = document.getElementById('studio');
if (target) mount(App, { target });
