// The connection to the server: it is taken up again when it breaks, after pauses that grow. `events` is told
//   message(object)  a text of the server (docs/remote_protocol.md)
//   piece(buffer)    bytes of an image
//   state(name, seconds, reason)  'connecting', 'open', 'closed' and in how many seconds it tries again, or 'refused': it
//                    waits for wake(), as a server that has closed an idle page has not asked for the same again
//   failed(text)     what came is no message

const kFirstPause = 0.5;  // seconds
const kLongestPause = 15;
const kNormalClosure = 1000;
const kPolicyViolation = 1008;

/// Of the page, with the token of the page's own address.
export function socketAddress(page) {
  const address = new URL('ws', page);
  address.protocol = page.protocol === 'https:' ? 'wss:' : 'ws:';
  address.search = '';
  address.hash = '';
  const token = new URLSearchParams(page.search).get('token');
  if (token !== null) {
    address.searchParams.set('token', token);
  }
  return address.href;
}

export class Connection {
  constructor(address, events) {
    this.address = address;
    this.events = events;
    this.pause = kFirstPause;
    this.isRefused = false;
    this.open();
  }

  open() {
    this.isRefused = false;
    this.events.state('connecting', 0);
    const socket = new WebSocket(this.address);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    socket.addEventListener('open', () => {
      this.events.state('open', 0);
    });
    socket.addEventListener('message', ({data}) => this.take(data));
    socket.addEventListener('close', ({code, reason}) => {
      if (this.socket !== socket) {
        return;
      }
      this.isRefused = code === kPolicyViolation;
      if (this.isRefused) {
        this.events.state('refused', 0, reason);
        return;
      }
      const seconds = this.pause * (0.75 + 0.5 * Math.random());
      this.pause = Math.min(2 * this.pause, kLongestPause);
      this.retry = setTimeout(() => this.open(), 1000 * seconds);
      this.events.state('closed', seconds, code === kNormalClosure ? '' : reason);
    });
  }

  take(data) {
    try {
      if (data instanceof ArrayBuffer) {
        this.events.piece(data);
      } else {
        const message = JSON.parse(data);
        if (message.type === 'hello') {
          this.pause = kFirstPause;  // it is the server, and lets this page in
        }
        this.events.message(message);
      }
    } catch (error) {
      this.events.failed(`The server sent something that this page does not understand: ${error.message}`);
    }
  }

  get isOpen() {
    return this.socket.readyState === WebSocket.OPEN;
  }

  send(message) {
    if (this.isOpen) {
      this.socket.send(JSON.stringify(message));
    }
  }

  /// The user is there.
  wake() {
    if (this.isRefused) {
      this.tryNow();
    }
  }

  /// Without waiting for the pause to end.
  tryNow() {
    if (this.socket.readyState === WebSocket.CLOSED) {
      clearTimeout(this.retry);
      this.open();
    }
  }
}
