/* Asks for the token where others reach the console. */
import {act} from './server.js';

document.getElementById('ask').addEventListener('submit', async event => {
  event.preventDefault();
  const answer = document.getElementById('answer');
  try {
    await act('token', {token: document.getElementById('token').value.trim()});
    location.reload();
  } catch (failure) {
    answer.textContent = failure.message;
  }
});
