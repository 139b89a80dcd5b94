#lang racket/base
;; The output of a program, sent on while it is written.
;;
;; A stream is a port for the program, and a thread that sends its output some fifty times a
;; second.  A program that writes faster waits for it.  More than a million bytes of a cell are
;; counted, not sent.

(provide make-text-stream text-stream-port send-rest! begin-cell! left-out)

;; in, port : ends of a pipe; send : text -> void; turn : one thread sends at a time;
;; pending : bytes that begin a character; sent, dropped : bytes of this cell
(struct text-stream (in port send turn [pending #:mutable] [sent #:mutable] [dropped #:mutable]))

(define pipe-size 65536)
(define most-bytes 1000000)
(define pause 0.02)

;; send : text -> void
(define (make-text-stream send)
  (define-values (in port) (make-pipe pipe-size))
  (define s (text-stream in port send (make-semaphore 1) #"" 0 0))
  (thread (lambda ()
            (let loop ()
              (sync in)
              (sleep pause)
              (send-rest! s)
              (loop))))
  s)

;; Sends all that was written.
(define (send-rest! s)
  (parameterize-break #f
    (call-with-semaphore
     (text-stream-turn s)
     (lambda ()
       (define buffer (make-bytes pipe-size))
       (let loop ()
         (define n (read-bytes-avail!* buffer (text-stream-in s)))
         (when (and (exact-integer? n) (positive? n))
           (send-bytes! s (subbytes buffer 0 n))
           (loop)))))))

(define (send-bytes! s written)
  (define room (max 0 (- most-bytes (text-stream-sent s))))
  (define taken (min room (bytes-length written)))
  (set-text-stream-sent! s (+ (text-stream-sent s) taken))
  (set-text-stream-dropped! s (+ (text-stream-dropped s) (- (bytes-length written) taken)))
  (when (positive? taken)
    (define-values (text rest)
      (decoded (bytes-append (text-stream-pending s) (subbytes written 0 taken))))
    (set-text-stream-pending! s rest)
    (unless (string=? text "") ((text-stream-send s) text))))

;; -> the text, and the bytes of a character that is not whole
(define (decoded written)
  (define n (bytes-length written))
  (define whole
    (or (for/first ([k (in-range 1 (min 4 (add1 n)))]
                    #:when (begins-character? (bytes-ref written (- n k)) k))
          (- n k))
        n))
  (values (bytes->string/utf-8 (subbytes written 0 whole) #\uFFFD) (subbytes written whole)))

;; Does the byte begin a character of more than k bytes?
(define (begins-character? byte k)
  (> (cond [(>= byte #xF0) 4] [(>= byte #xE0) 3] [(>= byte #xC0) 2] [else 1]) k))

(define (begin-cell! s)
  (set-text-stream-pending! s #"")
  (set-text-stream-sent! s 0)
  (set-text-stream-dropped! s 0))

;; Bytes of this cell that were not sent.
(define (left-out s) (text-stream-dropped s))
