"""Writes a log anew with chunks that are not compressed."""

import sys

from mcap.reader import make_reader
from mcap.writer import CompressionType, Writer


def main():
    with open(sys.argv[1], "rb") as source, open(sys.argv[2], "wb") as target:
        reader = make_reader(source)
        writer = Writer(target, compression=CompressionType.NONE)
        writer.start(profile="ros2", library="uncompress.py")
        for record in reader.iter_metadata():
            writer.add_metadata(record.name, record.metadata)
        channels = {}
        for schema, channel, message in reader.iter_messages(log_time_order=False):
            if channel.id not in channels:
                schema_id = writer.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.id] = writer.register_channel(channel.topic, channel.message_encoding, schema_id)
            writer.add_message(
                channels[channel.id], message.log_time, message.data, message.publish_time, message.sequence
            )
        writer.finish()


main()
