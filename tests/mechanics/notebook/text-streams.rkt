#lang racket/base
;; The output of a program, as it is sent on: whole characters, and no more than a million bytes.

(require mechanics/notebook/text-stream
         "../support/checks.rkt" "../support/patience.rkt")

;; -> a stream, and -> the texts that it sent, in order
(define (stream-and-texts)
  (define sent '())
  (values (make-text-stream (lambda (text) (set! sent (cons text sent))))
          (lambda () (reverse sent))))

(define text "a\u00DF\u20AC\u0915\U1F600z")
(define bytes (string->bytes/utf-8 text))

;; The characters of the text that its first n bytes hold
(define (whole n)
  (for/last ([k (in-range (+ 1 (string-length text)))]
             #:when (<= (string-utf-8-length text 0 k) n))
    (substring text 0 k)))

(test-case "characters of one to four bytes are whole, and sent at once, wherever a text is cut"
  (for* ([i (in-range (+ 1 (bytes-length bytes)))] [j (in-range i (+ 1 (bytes-length bytes)))])
    (define-values (s texts) (stream-and-texts))
    (for ([from (list 0 i j)] [to (list i j (bytes-length bytes))])
      (write-bytes bytes (text-stream-port s) from to)
      (send-rest! s)
      (check-equal? (apply string-append (texts)) (whole to)))))

;; The procedure that sends waits for the test.
(test-case "one thread sends at a time, and a break of it loses nothing"
  (define-values (sends may-send) (values (make-semaphore) (make-semaphore)))
  (define sent '())
  (define s
    (make-text-stream (lambda (text)
                        (semaphore-post sends)
                        (semaphore-wait may-send)
                        (set! sent (cons text sent)))))
  (write-string "one" (text-stream-port s))
  (define first-sender (thread (lambda () (send-rest! s))))
  (sync/patience 10 sends)
  (write-string "two" (text-stream-port s))
  (define second-sender (thread (lambda () (send-rest! s))))
  (check-false (sync/timeout 0.1 sends))
  (break-thread first-sender)
  (check-false (sync/timeout 0.1 sends))
  (semaphore-post may-send)
  (semaphore-post may-send)
  (for ([t (list first-sender second-sender)]) (sync/patience 10 t))
  (check-equal? (apply string-append (reverse sent)) "onetwo"))

(test-case "beyond a million bytes of a cell they are counted; the next cell begins anew"
  (define-values (s texts) (stream-and-texts))
  (define (write-lines n)
    (for ([_ n])
      (write-string (make-string 1000 #\x) (text-stream-port s))
      (send-rest! s)))
  (write-lines 1003)
  (check-equal? (apply + (map string-length (texts))) 1000000)
  (check-equal? (left-out s) 3000)
  (begin-cell! s)
  (check-equal? (left-out s) 0)
  (write-lines 2)
  (check-equal? (apply + (map string-length (texts))) 1002000))
